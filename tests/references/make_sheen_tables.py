#!/usr/bin/python3
"""The tables of studies/zeltner-*.toml, from the table that Zeltner, Burley and Chiang published in 2022.

    make_sheen_tables.py TABLE --write FOLDER   writes the tables into FOLDER
    make_sheen_tables.py TABLE --check FOLDER   compares them with those in FOLDER

TABLE is fitting/python/data/ltc_table_sheen_volume.cpp of the repository tizian/ltc-sheen, as of commit 344d95b8dd. It has 32 rows, one for
each roughness y, of 32 entries, one for each cosine x of the view. An entry holds aInv, bInv and the reflectance. Its renderer reads entry k
of 32 at k/31. Nothing is computed here: the digits are those of the file. 80 entries hold 0 for aInv and bInv, as their reflectance is below
0.000003 and the authors' program skips these.
"""
import os
import re
import sys

NODES = [f"{k / 31:.12g}" for k in range(32)]


def tables(text):
    entries = re.findall(r"\((-?[0-9.]+), (-?[0-9.]+), (-?[0-9.]+)\)", text)
    if len(entries) != 1024:
        sys.exit(f"the table has {len(entries)} entries, not 1024")
    result = {}
    for column, name in enumerate(("a", "b", "albedo")):
        lines = ["x,y,value"]
        for k, entry in enumerate(entries):
            if k < 32:  # y = 0: the forms of the source are 0 or 0/0, whatever their constants
                continue
            lines.append(f"{NODES[k % 32]},{NODES[k // 32]},{entry[column]}")
        result[f"zeltner-{name}.csv"] = "\n".join(lines) + "\n"
    return result


def main(arguments):
    if len(arguments) != 3 or arguments[1] not in ("--write", "--check"):
        sys.exit(__doc__)
    with open(arguments[0], encoding="utf-8") as file:
        found = tables(file.read())
    for name, content in found.items():
        path = os.path.join(arguments[2], name)
        if arguments[1] == "--write":
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
            continue
        with open(path, encoding="utf-8") as file:
            if file.read() != content:
                sys.exit(f"{path} differs from the table")


if __name__ == "__main__":
    main(sys.argv[1:])
