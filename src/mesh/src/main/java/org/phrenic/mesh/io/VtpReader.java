package org.phrenic.mesh.io;

import java.util.Arrays;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ByteCursor;
import org.phrenic.mesh.TriangleMesh;

/**
 * Reader of VTK XML PolyData (docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html). Arrays may be text,
 * base64 or appended (raw or base64), plain, zlib or LZ4, in either byte order. Pieces are concatenated in order.
 */
final class VtpReader {
    private final String file;
    private final byte[] bytes;
    private final VtpDocument document;
    private final PolygonSoup soup = new PolygonSoup();

    private VtpReader(String file, byte[] bytes) {
        this.file = file;
        this.bytes = bytes;
        this.document = VtpDocument.read(file, bytes);
    }

    static TriangleMesh read(String file, byte[] bytes) {
        int start = ByteCursor.textStart(bytes);
        VtpReader reader = new VtpReader(file, start == 0 ? bytes : Arrays.copyOfRange(bytes, start, bytes.length));
        for (VtpDocument.Piece piece : reader.document.pieces) {
            int base = reader.soup.vertexCount();
            reader.readPoints(piece);
            reader.readCells(piece, "Polys", piece.polys(), base);
            reader.readCells(piece, "Strips", piece.strips(), base);
        }
        return reader.soup.toMesh(file);
    }

    private void readPoints(VtpDocument.Piece piece) {
        if (piece.points() == 0) {
            return;
        }
        VtpArray array = array(piece, "Points");
        double[] values = array.doubles(bytes);
        if (values.length % 3 != 0 || values.length / 3 != piece.points()) {
            String found = "found " + values.length + " coordinates";
            throw badPiece(piece, found + ", expected 3 for each of " + piece.points() + " points");
        }
        for (int i = 0; i < values.length; i += 3) {
            array.setIndex(i);
            soup.vertex(array, values[i], values[i + 1], values[i + 2]);
        }
    }

    private void readCells(VtpDocument.Piece piece, String section, long cells, int base) {
        if (cells == 0) {
            return;
        }
        VtpArray offsetArray = array(piece, section + "/offsets");
        VtpArray cornerArray = array(piece, section + "/connectivity");
        long[] offsets = offsetArray.longs(bytes);
        long[] corners = cornerArray.longs(bytes);
        if (offsets.length != cells || offsets[offsets.length - 1] != corners.length) {
            String found = "found " + offsets.length + " offsets into " + corners.length + " corners of " + section;
            throw badPiece(piece, found + ", expected " + cells + " offsets up to the last corner");
        }
        for (int i = 0; i < corners.length; i++) {
            if (corners[i] < 0 || corners[i] >= piece.points()) {
                throw cornerArray.badInput(
                        i, "found vertex index " + corners[i] + ", expected 0 to " + (piece.points() - 1));
            }
            corners[i] += base;
        }
        long begin = 0;
        for (int c = 0; c < offsets.length; c++) {
            offsetArray.setIndex(c);
            if (offsets[c] < begin || offsets[c] > corners.length) {
                throw offsetArray.badInput("found offset " + offsets[c] + " after " + begin
                        + ", expected offsets that grow up to " + corners.length);
            }
            cornerArray.setIndex(begin);
            if (section.equals("Polys")) {
                soup.polygon(cornerArray, corners, (int) begin, (int) offsets[c]);
            } else {
                soup.strip(cornerArray, corners, (int) begin, (int) offsets[c]);
            }
            begin = offsets[c];
        }
    }

    private VtpArray array(VtpDocument.Piece piece, String name) {
        VtpDocument.DataArray array = piece.arrays().get(name);
        if (array == null) {
            throw badPiece(piece, "found no array " + name + ", expected one");
        }
        return new VtpArray(file, document, array);
    }

    private BadInputException badPiece(VtpDocument.Piece piece, String problem) {
        return BadInputException.at(file, "line " + piece.line() + ", Piece", problem);
    }
}
