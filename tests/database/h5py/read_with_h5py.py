"""Reads a database as any BEMIO reader would and compares it with the same ship as text.

Usage: read_with_h5py.py WRITER FOLDER; WRITER FOLDER writes ship.h5 and ship.csv there first.
Everything here is worked out anew from the layout's own rules (dimensional = stored x factor; waves
towards wave_dir, counter-clockwise; crest over the origin), not from the C++.
"""
import csv
import os
import subprocess
import sys

import h5py
import numpy as np


def table(path):
    values = {}
    with open(path) as file:
        for row in csv.DictReader(file):
            key = (int(row["i"]), int(row["j"]), int(row["k"]))
            values.setdefault(row["name"], {})[key] = complex(float(row["re"]), float(row["im"]))
    return values


def series(rows, n=None):
    """(6, 6[, n]) from the text."""
    count = 1 + max(i for i, _, _ in rows)
    out = np.array([[[rows[(i, j, k)].real for i in range(count)] for k in range(1, 7)]
                    for j in range(1, 7)])
    return out if n is None else out[:, :, :n]


def same(found, expected, what):
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape, (what, found.shape, expected.shape)
    # round-off of a handful of products, relative to the largest value
    assert np.max(np.abs(found - expected)) <= 1e-14 * np.max(np.abs(expected)), what


def check_storage(name, item):
    """Every number is a contiguous little-endian float64 with both attributes."""
    if name.startswith("cutwater") or not isinstance(item, h5py.Dataset):
        return
    if h5py.check_string_dtype(item.dtype) or item.dtype.kind == "S":
        assert item.shape == (), name
        return
    assert item.dtype == np.dtype("<f8") and item.chunks is None, name
    assert len(item.shape) >= 2, name
    assert {"description", "units"} <= set(item.attrs), name
    assert np.all(np.isfinite(item[()])), name


def check_components(group, array, period, names):
    """components/J_K hold (abscissa, value) of array[j, k, :]."""
    assert set(group) == names
    for name in names:
        j, k = (int(part) - 1 for part in name.split("_"))
        assert np.array_equal(group[name][()], np.column_stack([period, array[j, k]])), name


def check_radiation(h5, text, rho, g, w):
    body = h5["body1/hydro_coeffs"]
    pairs = {f"{j}_{k}" for j in range(1, 7) for k in range(1, 7)}
    period = 2 * np.pi / w
    same(body["linear_restoring_stiffness"][()] * rho * g, series(text["C"])[:, :, 0], "C")
    same(body["added_mass/inf_freq"][()] * rho, series(text["Ainf"])[:, :, 0], "A(inf)")
    same(body["added_mass/all"][()] * rho, series(text["A"]), "A")
    same(body["radiation_damping/all"][()] * rho * w, series(text["B"]), "B")
    for name in ("added_mass", "radiation_damping"):
        check_components(body[name + "/components"], body[name + "/all"][()], period, pairs)
    response = body["radiation_damping/impulse_response_fun"]
    same(response["K"][()] * rho, series(text["K"]), "K")
    t = response["t"][:, 0]
    same(t, text["step"][(0, 0, 0)].real * np.arange(len(t)), "t")
    check_components(response["components/K"], response["K"][()], t, pairs)


def expected_excitation(text, h5, name, w, g):
    """(6, headings, frequencies), headings as in the file, crest moved from G to the origin."""
    beta = np.array([text["beta"][(h, 0, 0)].real for h in range(len(text["beta"]))])
    x, y = text["cg"][(0, 0, 0)].real, text["cg"][(0, 1, 0)].real
    directions = h5["simulation_parameters/wave_dir"][:, 0]
    assert np.all(np.diff(directions) > 0)
    assert np.all(directions > -180) and np.all(directions <= 180)
    out = np.empty((6, len(directions), len(w)), complex)
    for column, direction in enumerate(directions):
        towards = np.radians(direction)
        gap = np.abs(np.exp(1j * -beta) - np.exp(1j * towards))
        h = int(np.argmin(gap))
        assert gap[h] < 1e-12, "no such heading"
        # A crest over the origin reaches G, x cos + y sin further along its way, later by k times
        # that.
        lag = np.exp(-1j * w**2 / g * (x * np.cos(towards) + y * np.sin(towards)))
        for j in range(6):
            out[j, column] = lag * np.array([text[name][(i, j + 1, h)] for i in range(len(w))])
    return out


def check_excitation(h5, text, rho, g, w):
    group = h5["body1/hydro_coeffs/excitation"]
    incident = expected_excitation(text, h5, "FI", w, g)
    scattered = expected_excitation(text, h5, "FD", w, g)
    names = {f"{j}_{h}" for j in range(1, 7) for h in range(1, incident.shape[1] + 1)}
    for where, force in ((group, incident + scattered), (group["froude-krylov"], incident),
                         (group["scattering"], scattered)):
        re, im, mag, phase = (where[part][()] for part in ("re", "im", "mag", "phase"))
        same((re + 1j * im) * rho * g, force, where.name)
        same(mag * np.exp(1j * phase), re + 1j * im, where.name + " mag, phase")
        for part in ("re", "im", "mag", "phase"):
            check_components(where["components"][part], where[part][()], 2 * np.pi / w, names)
    response = group["impulse_response_fun"]
    check_components(response["components/f"], response["f"][()], response["t"][:, 0], names)
    check_response(response, group["re"][()] + 1j * group["im"][()], w)


def check_response(response, force, w):
    """f(t) = (1/pi) Int (re cos wt - im sin wt) dw on the file's own w, by the trapezoidal rule."""
    fine, t, f = response["w"][:, 0], response["t"][:, 0], response["f"][()]
    assert fine[0] == 0 and np.isclose(fine[-1], w[-1]) and np.allclose(t, -t[::-1])
    # five-point data: the cubic through the four nodes around each fine frequency
    value = np.empty(force.shape[:2] + fine.shape, complex)
    for i, at in enumerate(np.clip(fine, w[0], w[-1])):
        first = min(max(np.searchsorted(w, at, side="right") - 2, 0), len(w) - 4)
        nodes = w[first:first + 4]
        weight = [np.prod([(at - b) / (a - b) for b in nodes if b != a]) for a in nodes]
        value[:, :, i] = force[:, :, first:first + 4] @ weight
    for i in range(0, len(t), max(1, len(t) // 9)):
        integrand = value.real * np.cos(fine * t[i]) - value.imag * np.sin(fine * t[i])
        expected = np.trapz(integrand, fine) / np.pi
        assert np.max(np.abs(f[:, :, i] - expected)) < 1e-12 * np.max(np.abs(f)), t[i]


def main():
    writer, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    subprocess.run([writer, folder], check=True)
    text = table(os.path.join(folder, "ship.csv"))
    with h5py.File(os.path.join(folder, "ship.h5"), "r") as h5:
        h5.visititems(check_storage)
        parameters, properties = h5["simulation_parameters"], h5["body1/properties"]
        rho, g = parameters["rho"][0, 0], parameters["g"][0, 0]
        assert (rho, g) == (text["rho"][(0, 0, 0)], text["g"][(0, 0, 0)])
        w = parameters["w"][:, 0]
        same(w, [text["omega"][(i, 0, 0)].real for i in range(len(w))], "w")
        same(parameters["T"][:, 0], 2 * np.pi / w, "T")
        assert parameters["water_depth"][()] == b"infinite" and parameters["scaled"][0, 0] == 0
        assert h5["bem_data/code"][()] == b"Cutwater" and properties["name"][()] == b"sample"
        assert properties["disp_vol"][0, 0] == text["volume"][(0, 0, 0)].real
        for name in ("cg", "cb"):
            same(properties[name][:, 0], [text[name][(0, i, 0)].real for i in range(3)], name)
        check_radiation(h5, text, rho, g, w)
        check_excitation(h5, text, rho, g, w)
    print("every number agrees")


if __name__ == "__main__":
    main()
