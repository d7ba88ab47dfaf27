#!/usr/bin/env python3
"""Makes the corpus that the fuzzers begin with: python3 tests/fuzz/make_corpus.py. Each file shows some of the formats."""

import base64
import json
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent / "corpus"


def png(width, height, colour_type, rows, interlaced=0, depth=8):
    """A PNG; `rows` are the bytes of all rows, each with its filter before it."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    header = struct.pack(">IIBBBBB", width, height, depth, colour_type, 0, 0, interlaced)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9))
            + chunk(b"IEND", b""))


# 8 x 8 in one grey, as cjpeg writes it: baseline and progressive.
BASELINE_JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdASFxOQERXRTc4UG1RV19iZ2hnPk1x"
    "eXBkeFxlZ2P/wAALCAAIAAgBAREA/8QAFAABAAAAAAAAAAAAAAAAAAAAAP/EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAIAQEAAD8AP//Z")
PROGRESSIVE_JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdASFxOQERXRTc4UG1RV19iZ2hnPk1x"
    "eXBkeFxlZ2P/wgALCAAIAAgBAREA/8QAFAABAAAAAAAAAAAAAAAAAAAAAP/aAAgBAQAAAAF//8QAFBABAAAAAAAAAAAAAAAAAAAAAP/aAAgB"
    "AQABBQJ//8QAFBABAAAAAAAAAAAAAAAAAAAAAP/aAAgBAQAGPwJ//8QAFBABAAAAAAAAAAAAAAAAAAAAAP/aAAgBAQABPyF//9oACAEBAAAA"
    "EH//xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAE/EH//2Q==")


def data_uri(content, kind="image/png"):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


def document(**members):
    return {"asset": {"version": "2.0"}, **members}


def glb(content, binary):
    def chunk(kind, data, fill):
        data += fill * (-len(data) % 4)
        return struct.pack("<I", len(data)) + kind + data
    chunks = chunk(b"JSON", json.dumps(content, separators=(",", ":")).encode(), b" ")
    chunks += chunk(b"BIN\0", binary, b"\0")
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def with_image(image, **members):
    return document(materials=[{"pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}}],
                    textures=[{"source": 0}], images=[image], **members)


def gltf_files():
    rgb = png(2, 2, 2, b"\0" + bytes([9, 0, 0, 9, 51, 255]) + b"\0" + bytes([9, 255, 102, 9, 51, 0]))
    grey = png(3, 3, 0, b"".join(b"\0" + bytes(n) for n in (1, 1, 2, 1, 1, 3)), interlaced=1)
    extensions = {
        "KHR_materials_ior": {"ior": 1.33},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 0.5],
                                   "specularTexture": {"index": 0}, "specularColorTexture": {"index": 0}},
        "KHR_materials_clearcoat": {}}
    gloss = {"specularFactor": [0.1, 0.2, 0.3], "glossinessFactor": 0.5, "specularGlossinessTexture": {"index": 0}}
    yield "factors.gltf", document(
        materials=[{"name": "metal", "pbrMetallicRoughness": {
            "baseColorFactor": [0.8, 0.4, 0.2, 1], "metallicFactor": 0.5, "roughnessFactor": 0.25,
            "baseColorTexture": {"index": 0}}, "extensions": extensions},
            {"extensions": {"KHR_materials_unlit": {}}}],
        meshes=[{"primitives": [{"material": 0, "attributes": {"COLOR_0": 0}}, {}]}],
        nodes=[{"children": [0], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        extensions={"KHR_lights_punctual": {"lights": [{}]}}, accessors=[{"max": [1, 2]}])
    yield "gloss.gltf", document(materials=[{"extensions": {"KHR_materials_pbrSpecularGlossiness": gloss}}],
                                 textures=[{"source": 0}], images=[{"uri": data_uri(rgb)}])
    yield "interlaced.gltf", with_image({"uri": data_uri(grey)})
    yield "jpeg.gltf", with_image({"uri": data_uri(BASELINE_JPEG, "image/jpeg")})
    yield "progressive.gltf", with_image({"uri": data_uri(PROGRESSIVE_JPEG, "image/jpeg")})
    yield "outside.gltf", with_image({"uri": "%2e%2e/a.png"})
    yield "missing.gltf", with_image({"uri": "a%20b.png"}, buffers=[{"uri": "http://x.org/a", "byteLength": 1}])
    yield "buffer.gltf", with_image(
        {"bufferView": 0}, bufferViews=[{"buffer": 0, "byteOffset": 1, "byteLength": len(rgb)}],
        buffers=[{"byteLength": len(rgb) + 1, "uri": data_uri(b"?" + rgb, "application/octet-stream")}])
    yield "binary.glb", glb(with_image({"bufferView": 0}, bufferViews=[{"buffer": 0, "byteLength": len(rgb)}],
                                       buffers=[{"byteLength": len(rgb)}]), rgb)


MTL = {
    "phong.mtl": "# by hand\nnewmtl a b\n Ns 50.0\n Ni 1.5\n Kd .8 0.7 0.6\n Ks 0.5 0.5 0.5\n illum 2\n"
                 " map_Ks -s 1 1 1 ks.png\n map_Ns -imfchan r ns.png\nnewmtl c\r\nKs 1\r\nillum 1\r\nTr 0.5\r\nd 1\r\n",
    "physical.mtl": "newmtl a\nPr 0.5\nPm 1\nKd 2 0.5 0\nmap_Pr -clamp on -o 1 2 r.png\nmap_Pm m.tga\nmap_Kd k.jpg\n"
                    "aniso 0.5\nPcr 1\nnewmtl b\nPm 0.5\nmap_Ka -mm 0 1 a.png\nbump -bm 1.5 b.png\n",
    "bad.mtl": "newmtl a\nNs abc\nKs 1 2\nPr 1.5\nNi nan\nillum x\n",
}


def main():
    for name in ("read_gltf", "read_mtl"):
        (FOLDER / name).mkdir(parents=True, exist_ok=True)
    for name, content in gltf_files():
        if not isinstance(content, bytes):
            content = json.dumps(content, separators=(",", ":")).encode()
        (FOLDER / "read_gltf" / name).write_bytes(content)
    for name, text in MTL.items():
        (FOLDER / "read_mtl" / name).write_text(text, newline="")


if __name__ == "__main__":
    main()
