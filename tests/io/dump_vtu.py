"""Prints what a .vtu file holds, one array a line, by nothing but the Python library.

Of more than 1000 values it prints their number and the sum of (i + 1) * value, as whole numbers.

Usage: dump_vtu.py FILE        exit code 1 and a message when the file breaks VTK's layout
"""
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zlib

FORMATS = {"Float64": "d", "Int64": "q", "UInt8": "B"}


def blocks(data, offset):
    """Uncompressed bytes of the array at offset, and where it ends."""
    count, size, last = struct.unpack_from("<3Q", data, offset)
    sizes = struct.unpack_from(f"<{count}Q", data, offset + 24)
    at = offset + 24 + 8 * count
    result = b""
    for i, compressed in enumerate(sizes):
        block = zlib.decompress(data[at:at + compressed])
        wanted = last if last and i + 1 == count else size
        assert len(block) == wanted, f"block {i}: {len(block)} bytes, {wanted} announced"
        result += block
        at += compressed
    return result, at


def main(path):
    raw = open(path, "rb").read()
    marker = b'<AppendedData encoding="raw">\n_'
    head, rest = raw.split(marker, 1)
    root = ElementTree.fromstring(head + b"</VTKFile>")
    assert root.attrib["byte_order"] == "LittleEndian" and root.attrib["header_type"] == "UInt64"
    assert root.attrib["compressor"] == "vtkZLibDataCompressor"
    piece = root.find("UnstructuredGrid/Piece")
    print(piece.attrib["NumberOfPoints"], piece.attrib["NumberOfCells"])
    end = 0
    for section in piece:
        for array in section:
            assert int(array.attrib["offset"]) == end, "arrays do not follow each other"
            data, end = blocks(rest, end)
            code = FORMATS[array.attrib["type"]]
            values = struct.unpack(f"<{len(data) // struct.calcsize('<' + code)}{code}", data)
            active = [k for k, v in section.attrib.items() if v == array.attrib["Name"]]
            shown = [repr(v) for v in values]
            if len(values) > 1000:
                shown = [len(values), sum((i + 1) * int(v) for i, v in enumerate(values))]
            print(section.tag, *active, array.attrib["type"], array.attrib["Name"],
                  array.attrib["NumberOfComponents"], *shown)
    assert rest[end:] == b"\n</AppendedData>\n</VTKFile>\n", "something else after the last array"


main(sys.argv[1])
