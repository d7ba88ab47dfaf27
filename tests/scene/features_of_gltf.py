#!/usr/bin/env python3
"""Prints the features of the used materials of glTF files by value, from their JSON alone.
Written from the specifications of glTF 2.0 and its extensions, not from shadefit's reader. Pictures are not
decoded: a texture of metallic and roughness counts for both. Output: [[name, [feature, ..]], ..] for each file.
"""
import json
import struct
import sys

LOBES = [("diffuse_transmission", "diffuse transmission", "diffuseTransmissionFactor"),
         ("transmission", "transmission", "transmissionFactor"), ("volume", "volume", "thicknessFactor"),
         ("dispersion", "dispersion", "dispersion"), ("anisotropy", "anisotropy", "anisotropyStrength"),
         ("clearcoat", "clear coat", "clearcoatFactor"), ("sheen", "sheen", "sheenColorFactor"),
         ("iridescence", "iridescence", "iridescenceFactor")]
KHR = "extensions/KHR_materials_"


class Material:
    def __init__(self, material, pointer, coloured, animated):
        self.json, self.pointer, self.coloured, self.animated = material, pointer, coloured, animated

    def get(self, path, default=None):
        here = self.json
        for key in path.split("/"):
            if key not in here:
                return default
            here = here[key]
        return here

    def moves(self, path):
        return f"{self.pointer}/{path}" in self.animated

    def is_not(self, path, neutral, default):
        value = self.get(path, default)
        return self.moves(path) or any(n != neutral for n in (value if isinstance(value, list) else [value]))

    def texture(self, path, feature, factor=True):
        """A texture times its factor, its normal's scale or its occlusion's strength; and its transform."""
        if self.get(path) is None or not factor:
            return []
        if not self.is_not(path + "/scale", 0, 1) or not self.is_not(path + "/strength", 0, 1):
            return []
        transform = path + "/extensions/KHR_texture_transform/"
        moved = any(self.is_not(transform + key, n, n) for key, n in (("offset", 0), ("rotation", 0), ("scale", 1)))
        return [feature] + ["texture transform"] * moved

    def textures_of(self, extension, feature):
        found = []
        for key in [key for key in self.get(extension, {}) if key.endswith("Texture")]:
            factor = key.replace("Texture", "Factor")
            default = 0 if factor in ("clearcoatRoughnessFactor", "sheenRoughnessFactor") else 1
            on = self.is_not(f"{extension}/{factor}", 0, default)
            found += self.texture(f"{extension}/{key}", feature + " texture", on)
        return found

    def features(self):
        unlit = self.get(KHR + "unlit") is not None
        glossy = self.get(KHR + "pbrSpecularGlossiness") is not None and not unlit
        base = KHR + "pbrSpecularGlossiness" if glossy else "pbrMetallicRoughness"
        name = base + ("/diffuse" if glossy else "/baseColor")
        colour = self.get(name + "Factor", [1, 1, 1, 1])
        unknown = self.coloured or self.get(name + "Texture") is not None or self.moves(name + "Factor")
        alpha, mode, found = 0 if unknown else colour[3], self.get("alphaMode"), set()
        if mode == "MASK" and (alpha < self.get("alphaCutoff", 0.5) or self.moves("alphaCutoff")):
            found.add("alpha mask")
        if mode == "BLEND" and alpha < 1:
            found.add("alpha blend")
        seen = any(colour[:3]) or self.moves(name + "Factor") or bool(found)
        found.update(self.texture(name + "Texture", "base colour texture", seen))
        found.update(["vertex colours"] * (self.coloured and seen))
        found.update(["double sided"] * self.get("doubleSided", False) + ["unlit"] * unlit)
        if unlit:
            return sorted(found)
        mixed, all_metal = base + "/metallicRoughnessTexture", False
        if glossy:
            name = "specular-glossiness"
            found.update([name] + self.texture(base + "/specularGlossinessTexture", name + " texture"))
        else:
            for part in ("metallic", "roughness"):
                found.update(self.texture(mixed, part + " texture", self.is_not(f"{base}/{part}Factor", 0, 1)))
            all_metal = not self.is_not(base + "/metallicFactor", 1, 1) and self.get(mixed) is None
        found.update(self.texture("normalTexture", "normal map"))
        found.update(self.texture("occlusionTexture", "occlusion texture"))
        if self.is_not("emissiveFactor", 0, 0) and self.is_not(KHR + "emissive_strength/emissiveStrength", 0, 1):
            found.update(["emission"] + self.texture("emissiveTexture", "emission texture"))
        for extension, feature, factor in LOBES:
            needs = {"volume": {"transmission", "diffuse transmission"}, "dispersion": {"volume"}}.get(extension)
            if (needs and not needs & found) or (all_metal and extension.endswith("transmission")):
                continue
            if self.is_not(f"{KHR}{extension}/{factor}", 0, 0):
                found.update([feature] + self.textures_of(KHR + extension, feature))
        if not all_metal:
            textures = self.textures_of(KHR + "specular", "specular")
            if textures or any(self.is_not(f"{KHR}specular/specular{f}Factor", 1, 1) for f in ("", "Color")):
                found.update(["specular"] + textures)
            found.update(["ior"] * self.is_not(KHR + "ior/ior", 1.5, 1.5))
        return sorted(found)


def used_materials(document):
    materials, used, coloured, animated = document.get("materials", []), set(), set(), set()
    for primitive in [p for mesh in document.get("meshes", []) for p in mesh["primitives"]]:
        variants = primitive.get("extensions", {}).get("KHR_materials_variants", {}).get("mappings", [])
        indices = {primitive.get("material", len(materials))} | {v["material"] for v in variants}
        used |= indices
        coloured |= indices if "COLOR_0" in primitive.get("attributes", {}) else set()
    for channel in [c for a in document.get("animations", []) for c in a.get("channels", [])]:
        animated.add(channel["target"].get("extensions", {}).get("KHR_animation_pointer", {}).get("pointer"))
    is_all = not used or "MSFT_lod" in document.get("extensionsUsed", [])
    named = [(m.get("name", f"material {i}"), m, i) for i, m in enumerate(materials) if is_all or i in used]
    if not materials or len(materials) in used:
        named.append(("default", {}, len(materials)))
    return [[name, Material(m, f"/materials/{i}", i in coloured, animated).features()] for name, m, i in named]


for path in sys.argv[1:]:
    data = open(path, "rb").read()
    if data[:4] == b"glTF":
        data = data[20:20 + struct.unpack_from("<I", data, 12)[0]]
    print(json.dumps(used_materials(json.loads(data))))
