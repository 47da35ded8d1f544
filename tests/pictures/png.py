"""Reads PNG files of 8-bit RGB with nothing but the standard library."""
import struct
import zlib


class Picture:
    def __init__(self, path):
        data = path.read_bytes()
        assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG file"
        place, compressed, ended = 8, b"", False
        while place < len(data):
            length, kind = struct.unpack(">I4s", data[place:place + 8])
            chunk = data[place + 8:place + 8 + length]
            checksum, = struct.unpack(">I", data[place + 8 + length:place + 12 + length])
            assert checksum == zlib.crc32(kind + chunk), f"{path}: chunk {kind} is damaged"
            if kind == b"IHDR":
                self.width, self.height, depth, colours, _, _, interlaced = struct.unpack(
                    ">IIBBBBB", chunk)
                assert (depth, colours, interlaced) == (8, 2, 0), f"{path}: not plain RGB"
            elif kind == b"IDAT":
                compressed += chunk
            elif kind == b"IEND":
                ended = True
            place += 12 + length
        assert ended, f"{path} ends early"
        self.rows = self._unfiltered(zlib.decompress(compressed))

    def _unfiltered(self, data):
        size = 3 * self.width
        assert len(data) == self.height * (size + 1)
        above, rows = bytearray(size), []
        for y in range(self.height):
            kind = data[y * (size + 1)]
            row = bytearray(data[y * (size + 1) + 1:(y + 1) * (size + 1)])
            for i in range(size):
                left = row[i - 3] if i >= 3 else 0
                up = above[i]
                corner = above[i - 3] if i >= 3 else 0
                if kind == 1:
                    predicted = left
                elif kind == 2:
                    predicted = up
                elif kind == 3:
                    predicted = (left + up) // 2
                elif kind == 4:
                    estimate = left + up - corner
                    predicted = min((left, up, corner), key=lambda value: abs(estimate - value))
                else:
                    predicted = 0
                row[i] = (row[i] + predicted) & 255
            rows.append(row)
            above = row
        return rows

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])

    def is_coloured(self, x, y):
        """Whether a pixel is neither grey nor white nor black."""
        colour = self.pixel(x, y)
        return max(colour) - min(colour) > 24
