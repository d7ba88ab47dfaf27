#!/usr/bin/python3
"""The Fourier transforms of the CIE 1931 colour matching functions, in 30 digits, for the tables of studies/airy-*.toml.

    make_airy_references.py FOLDER           writes airy-x.csv, airy-y.csv and airy-z.csv into FOLDER
    make_airy_references.py --check FOLDER   compares them with those in FOLDER

D is an optical path difference in nm. The value is the sum of s(w) cos(2 pi D/w) over the wavelengths w from 360 to 830 nm in steps of 1 nm,
divided by the sum of y(w). s is x, y or z of the table cie-1931.csv beside this program. Thin films need it (Belcour, Barla 2017).
"""
import os
import sys

from mpmath import cos, mp, mpf, pi

mp.dps = 30

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "cie-1931.csv"), encoding="utf-8") as file:
    OBSERVER = [[mpf(cell) for cell in line.split(",")] for line in file.read().split()[1:]]


def tables():
    lines = {"x": ["D,value"], "y": ["D,value"], "z": ["D,value"]}
    whole = sum(row[2] for row in OBSERVER)
    for path in range(0, 4001, 10):
        waves = [cos(2 * pi * path / row[0]) for row in OBSERVER]
        for column, name in enumerate("xyz", start=1):
            value = sum(row[column] * wave for row, wave in zip(OBSERVER, waves)) / whole
            lines[name].append(f"{path},{mp.nstr(value, 17)}")
    return {f"airy-{name}.csv": "\n".join(rows) + "\n" for name, rows in lines.items()}


checks = sys.argv[1:2] == ["--check"]
folder = sys.argv[2 if checks else 1]
for name, content in tables().items():
    path = os.path.join(folder, name)
    if not checks:
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)
        continue
    with open(path, encoding="utf-8") as file:
        if file.read() != content:
            sys.exit(f"{path} differs from what this program computes")
