package org.phrenic.mesh.voxel;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.WindowedSincFilter;

/**
 * Surface nets of a label volume: the surfaces between its parts, with shared vertices where parts are adjacent (Gibson
 * 1998, Constrained Elastic Surface Nets, doi 10.1007/BFb0056277; Frisken 2022, SurfaceNets for Multi-Label
 * Segmentations, https://jcgt.org/published/0011/01/03/). Each voxel face between two parts is a quadrilateral. Each
 * cube of eight voxel centres that contains several parts has one vertex, the mean of the crossings on the cube's
 * edges.
 *
 * <p>The surface of one part is a closed manifold that faces outward. Voxels of a part that touch only at an edge or a
 * corner are separate: the surface has several vertices at the same position there. Outside the box is background, so a
 * part that reaches the boundary of the box is closed there.
 */
public final class SurfaceNet {
    /** Vertices, mm. */
    private final double[] positions;
    /** Four vertices per voxel face, anticlockwise in mm seen from the voxel with the larger index. */
    private final int[] quads;
    /** Parts on both sides of a face: that of the voxel with the smaller index, then the other. */
    private final short[] sides;
    /** Three times the index of the first voxel in the grid padded by one voxel, plus the direction of the face. */
    private final long[] faces;
    /** Index increment of a padded voxel along each direction. */
    private final long[] strides;
    /** The faces of part p are {@code facesOfParts} from startOfPart[p] to startOfPart[p + 1] - 1, in order. */
    private final int[] startOfPart;

    private final int[] facesOfParts;

    SurfaceNet(double[] positions, int[] quads, short[] sides, long[] faces, long[] strides) {
        this.positions = positions;
        this.quads = quads;
        this.sides = sides;
        this.faces = faces;
        this.strides = strides;
        int most = 0;
        for (short side : sides) {
            most = Math.max(most, side);
        }
        startOfPart = new int[most + 2];
        for (short side : sides) {
            // The background has no surface.
            startOfPart[side + 1] += side > 0 ? 1 : 0;
        }
        for (int part = 0; part <= most; part++) {
            startOfPart[part + 1] += startOfPart[part];
        }
        facesOfParts = new int[startOfPart[most + 1]];
        int[] filled = new int[most + 1];
        for (int i = 0; i < sides.length; i++) {
            int part = sides[i];
            if (part > 0) {
                facesOfParts[startOfPart[part] + filled[part]++] = i >> 1;
            }
        }
    }

    /** The same net with other vertex positions. */
    private SurfaceNet(SurfaceNet net, double[] positions) {
        this.positions = positions;
        quads = net.quads;
        sides = net.sides;
        faces = net.faces;
        strides = net.strides;
        startOfPart = net.startOfPart;
        facesOfParts = net.facesOfParts;
    }

    /**
     * Builds the net of a volume.
     *
     * @param partOfLabel part of each label, at most 32,767; 0 for background and for labels beyond the end of the
     *     array
     */
    public static SurfaceNet of(LabelGrid grid, int[] partOfLabel) {
        return new SurfaceNetBuilder(grid, partOfLabel).build();
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    /**
     * The same net smoothed by {@link WindowedSincFilter}. Vertices where three or more parts meet are smoothed only
     * along the line between the parts.
     *
     * @param iterations degree of the filter
     * @param passBand above 0, below 2
     */
    public SurfaceNet smoothed(int iterations, double passBand) {
        double[] c = WindowedSincFilter.coefficients(iterations, passBand, WindowedSincFilter.Window.NUTTALL);
        SurfaceNetNeighbours neighbours = SurfaceNetNeighbours.of(vertexCount(), quads, sides);
        return new SurfaceNet(
                this, WindowedSincFilter.filter(positions, neighbours.start(), neighbours.neighbours(), c));
    }

    /** The surface of one part, closed and facing outward; empty if there is no such part. */
    public TriangleMesh surface(int part) {
        boolean known = part > 0 && part + 1 < startOfPart.length;
        int from = known ? startOfPart[part] : 0;
        int count = known ? startOfPart[part + 1] - from : 0;
        int[] own = new int[4 * count];
        long[] voxels = new long[count];
        int least = Integer.MAX_VALUE;
        int most = -1;
        for (int i = 0; i < count; i++) {
            int q = facesOfParts[from + i];
            boolean first = sides[2 * q] == part;
            for (int corner = 0; corner < 4; corner++) {
                int v = quads[4 * q + (first ? corner : 3 - corner)];
                own[4 * i + corner] = v;
                least = Math.min(least, v);
                most = Math.max(most, v);
            }
            long voxel = faces[q] / 3;
            voxels[i] = first ? voxel : voxel + strides[(int) (faces[q] % 3)];
        }
        return new QuadStitcher(ownPositions(own, least, most), own, voxels).mesh();
    }

    /**
     * Positions of the vertices in {@code own}, in ascending order; replaces the indices in {@code own} by indices into
     * the result. A net may have millions of vertices, while a rib has a few thousand.
     */
    private double[] ownPositions(int[] own, int least, int most) {
        int[] place = new int[Math.max(0, most - least + 1)];
        for (int v : own) {
            place[v - least] = 1;
        }
        int count = 0;
        for (int v = 0; v < place.length; v++) {
            count += place[v];
            place[v] = place[v] == 1 ? count - 1 : -1;
        }
        double[] named = new double[3 * count];
        for (int v = 0; v < place.length; v++) {
            if (place[v] >= 0) {
                System.arraycopy(positions, 3 * (least + v), named, 3 * place[v], 3);
            }
        }
        for (int i = 0; i < own.length; i++) {
            own[i] = place[own[i] - least];
        }
        return named;
    }
}
