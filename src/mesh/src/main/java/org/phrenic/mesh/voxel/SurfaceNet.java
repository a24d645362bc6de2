package org.phrenic.mesh.voxel;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.WindowedSincFilter;

/**
 * The surfaces between the parts of a volume of labels, as one net whose vertices neighbours share, so that their
 * surfaces meet (Gibson 1998, Constrained Elastic Surface Nets, doi 10.1007/BFb0056277; Frisken 2022, SurfaceNets for
 * Multi-Label Segmentations, https://jcgt.org/published/0011/01/03/). Each face of a voxel between two parts is a
 * quadrilateral; its corners are one vertex for each cube of eight voxel centres that holds several parts, in the
 * middle of the crossings on the cube's edges.
 *
 * <p>The surface of one part is closed, manifold and faces outward. Voxels of it that touch at an edge or a corner
 * alone are apart: there the surface has several vertices in one place. Beyond the box lies background, so what the box
 * cuts is closed flat.
 */
public final class SurfaceNet {
    /** Vertices, mm. */
    private final double[] positions;
    /** Four vertices a face of a voxel, anticlockwise seen from the voxel of the larger number, in mm. */
    private final int[] quads;
    /** Parts on both sides of a face: of the voxel of the smaller number, then the other. */
    private final short[] sides;
    /** Three times the number of the first voxel, padded by one all round, plus the face's direction. */
    private final long[] faces;
    /** What a step along each direction adds to the number of a padded voxel. */
    private final long[] strides;
    /** Faces of part p are those of {@code facesOfParts} from startOfPart[p] to before startOfPart[p + 1], in order. */
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

    /** The same net with its vertices elsewhere. */
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
     * The net of a volume.
     *
     * @param partOfLabel number of the part that each label belongs to, 0 for background and for labels beyond its end;
     *     at most 32,767
     */
    public static SurfaceNet of(LabelGrid grid, int[] partOfLabel) {
        return new SurfaceNetBuilder(grid, partOfLabel).build();
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    /**
     * The same net with smooth vertices, see {@link WindowedSincFilter}. Where three parts or more meet, vertices are
     * smoothed along the line at which they do.
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

    /** The surface of one part, closed and facing outward; without triangles if there is no such part. */
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
     * Positions of the vertices that are named, in their order; from then on they are named by their places there. A
     * net may have millions of vertices, of which a rib has a few thousand.
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
