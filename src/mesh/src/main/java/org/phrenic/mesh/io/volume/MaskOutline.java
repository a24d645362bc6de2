package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * What a contour may be the outline of, told by its corners in columns and rows of pixels. Outlines of masks step from
 * a pixel to one of the eight about it. Those along the edges of pixels never run diagonally or turn back on
 * themselves. A cut from an outline to that of a hole, which is passed both ways, may have any direction.
 */
enum MaskOutline {
    /** Of other directions, or with corners beside the lines of the pixels. */
    DRAWN,
    /** Along columns and rows only: along the edges of pixels, or drawn. */
    ALONG_AXES,
    /** Diagonal in part, or out and back along a line of pixels. */
    THROUGH_CENTRES;

    /** The most columns or rows of an image of DICOM. */
    private static final int MAX_CORNER = 0xFFFF;

    private record Edge(int x1, int y1, int x2, int y2) {
        int columns() {
            return x2 - x1;
        }

        int rows() {
            return y2 - y1;
        }

        boolean isDiagonal() {
            return columns() != 0 && rows() != 0;
        }

        /** Whether it runs along columns, rows or a diagonal of the pixels. */
        boolean steps() {
            return !isDiagonal() || Math.abs(columns()) == Math.abs(rows());
        }

        Edge back() {
            return new Edge(x2, y2, x1, y1);
        }

        boolean turnsBackTo(Edge next) {
            return (long) columns() * next.rows() == (long) rows() * next.columns()
                    && (long) columns() * next.columns() + (long) rows() * next.rows() < 0;
        }
    }

    static MaskOutline of(double[] corners) {
        for (double corner : corners) {
            if (!(corner == Math.rint(corner) && Math.abs(corner) <= MAX_CORNER)) {
                return DRAWN;
            }
        }
        List<Edge> edges = edges(corners);
        Set<Edge> all = new HashSet<>(edges);
        boolean isThroughCentres = false;
        for (int e = 0; e < edges.size(); e++) {
            Edge edge = edges.get(e);
            isThroughCentres |= edge.turnsBackTo(edges.get((e + 1) % edges.size()));
            if (edge.isDiagonal() && !all.contains(edge.back())) {
                if (!edge.steps()) {
                    return DRAWN;
                }
                isThroughCentres = true;
            }
        }
        return isThroughCentres ? THROUGH_CENTRES : ALONG_AXES;
    }

    /** The edges that have a length. */
    private static List<Edge> edges(double[] corners) {
        List<Edge> edges = new ArrayList<>();
        for (int c = 0; c < corners.length; c += 2) {
            int next = (c + 2) % corners.length;
            Edge edge = new Edge((int) corners[c], (int) corners[c + 1], (int) corners[next], (int) corners[next + 1]);
            if (edge.columns() != 0 || edge.rows() != 0) {
                edges.add(edge);
            }
        }
        return edges;
    }
}
