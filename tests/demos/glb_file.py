"""A reader of binary glTF of our own, of as much of it as meshes/boat uses."""
import json
import struct


class Glb:
    """`parts[name]` is a list of (material, triangles), a triangle three points (x, y, z)."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        magic, version, length, json_length, kind = struct.unpack_from("<4sIII4s", data)
        assert (magic, version, kind) == (b"glTF", 2, b"JSON") and length == len(data)
        self.json = json.loads(data[20:20 + json_length])
        binary_length, kind = struct.unpack_from("<I4s", data, 20 + json_length)
        assert kind == b"BIN\0" and 28 + json_length + binary_length == length
        self.binary = data[28 + json_length:]
        assert self.json["buffers"] == [{"byteLength": binary_length}]
        self.parts = {node["name"]: self.surfaces(node) for node in self.json["nodes"]}

    def numbers(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        letter, size = {5126: ("f", 4), 5123: ("H", 2)}[accessor["componentType"]]
        width = {"VEC3": 3, "SCALAR": 1}[accessor["type"]]
        assert view["byteLength"] == accessor["count"] * width * size
        values = struct.unpack_from(f"<{accessor['count'] * width}{letter}", self.binary,
                                    view["byteOffset"])
        if width == 1:
            return values
        points = [values[i:i + 3] for i in range(0, len(values), 3)]
        low, high = ([f(p[i] for p in points) for i in range(3)] for f in (min, max))
        # Written with nine digits, which single precision needs.
        for value, said in zip(low + high, accessor["min"] + accessor["max"]):
            assert abs(value - said) <= 1e-8 * abs(value)
        return points

    def surfaces(self, node):
        found = []
        for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
            points = self.numbers(primitive["attributes"]["POSITION"])
            indices = self.numbers(primitive["indices"])
            corners = [points[i] for i in indices]
            material = self.json["materials"][primitive["material"]]
            found.append((material, [corners[i:i + 3] for i in range(0, len(corners), 3)]))
        return found

    def triangles(self, name):
        return [triangle for _, surface in self.parts[name] for triangle in surface]
