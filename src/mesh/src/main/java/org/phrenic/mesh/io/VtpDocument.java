package org.phrenic.mesh.io;

import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import org.phrenic.file.ScalarType;

/**
 * What the XML part of a VTP file says: how numbers are stored, the pieces with their arrays, and where appended data
 * begins.
 *
 * @param order of all binary numbers
 * @param headerType UINT32 or UINT64, the type of the lengths before binary data
 * @param compressed whether binary data is cut into zlib blocks
 * @param appended bytes of the file from after the underscore of AppendedData, -1 without any
 * @param appendedRaw raw bytes there, else base64
 */
record VtpDocument(
        ByteOrder order,
        ScalarType headerType,
        boolean compressed,
        int appended,
        boolean appendedRaw,
        List<Piece> pieces) {

    /**
     * One DataArray element.
     *
     * @param text its content, for the formats ascii and binary
     * @param offset where it begins in the appended data, for the format appended
     */
    record DataArray(String name, ScalarType type, String format, long offset, String text, int line) {}

    /**
     * One Piece; {@code arrays} by "Points", "Polys/connectivity", "Polys/offsets", "Strips/connectivity",
     * "Strips/offsets".
     */
    record Piece(int line, long points, long polys, long strips, Map<String, DataArray> arrays) {}
}
