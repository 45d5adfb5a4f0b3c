"""HDF5 files with the seal of mc/RESULTS_FORMAT.md: proved whole before HDF5 opens them, which crashes on damaged files."""

import io
import lzma
import pathlib

import h5py

SEAL, BLOCK, SIGNATURE = b"cagetol sealed HDF5, version 1", 512, b"\x89HDF\r\n\x1a\n"


def crc64(data):
    """CRC-64/XZ: the check that an .xz stream of these bytes ends with, before its index and footer of 12 bytes."""
    stream = lzma.compress(data, format=lzma.FORMAT_XZ, check=lzma.CHECK_CRC64, preset=0)
    index = 4 * (int.from_bytes(stream[-8:-4], "little") + 1)
    return int.from_bytes(stream[-12 - index - 8:-12 - index], "little")


def open_sealed(path):
    """The file, open for reading. Throws FileNotFoundError, and ValueError where a byte is not as it was written."""
    path = pathlib.Path(path)
    data = path.read_bytes()
    if data.startswith(SIGNATURE):  # written by another program, or by one of old: without a seal
        return h5py.File(path, "r")
    seal, length, checksum = data[:BLOCK].rstrip(b"\0").split(b"\n")[:3] if data.count(b"\n", 0, BLOCK) >= 2 else (b"", b"", b"")
    whole = (seal == SEAL and length == b"bytes %d" % len(data) and checksum == b"crc64 %016x" % crc64(data[BLOCK:]))
    if not whole:
        raise ValueError(f"{path} is damaged: its bytes are not those that were written. Run the same command again to have it "
                         "built from the journals, or take a copy")
    return h5py.File(io.BytesIO(data), "r")
