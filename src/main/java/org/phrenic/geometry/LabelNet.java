package org.phrenic.geometry;

/**
 * The surfaces between the parts of a volume of labels, as one net whose vertices neighbours share, so that their surfaces meet (Gibson 1998, Constrained Elastic Surface Nets, doi 10.1007/BFb0056277;
 * Frisken 2022, SurfaceNets for Multi-Label Segmentations, https://jcgt.org/published/0011/01/03/). Each face of a voxel between two parts is a quadrilateral; its corners are one vertex for each cube of
 * eight voxel centres that holds several parts, in the middle of the crossings on the cube's edges.
 *
 * <p>The surface of one part is closed, manifold and faces outward. Voxels of it that touch at an edge or a corner alone are apart: there the surface has several vertices in one place. Beyond the box lies
 * background, so what the box cuts is closed flat.
 */
public final class LabelNet {
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

    LabelNet(double[] positions, int[] quads, short[] sides, long[] faces, long[] strides) {
        this.positions = positions;
        this.quads = quads;
        this.sides = sides;
        this.faces = faces;
        this.strides = strides;
    }

    /**
     * The net of a volume.
     *
     * @param partOfLabel number of the part that each label belongs to, 0 for background and for labels beyond its end; at most 32,767
     */
    public static LabelNet of(LabelGrid grid, int[] partOfLabel) {
        return new LabelNetBuilder(grid, partOfLabel).build();
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    public int faceCount() {
        return faces.length;
    }

    /**
     * The same net with smooth vertices, see {@link WindowedSinc}. Where three parts or more meet, vertices are smoothed along the line at which they do.
     *
     * @param iterations degree of the filter
     * @param passBand above 0, below 2
     */
    public LabelNet smoothed(int iterations, double passBand) {
        double[] c = WindowedSinc.coefficients(iterations, passBand, WindowedSinc.Window.NUTTALL);
        NetNeighbours neighbours = new NetNeighbours(vertexCount(), quads, sides);
        double[] smooth = WindowedSinc.filtered(positions, neighbours.start(), neighbours.neighbours(), c);
        return new LabelNet(smooth, quads, sides, faces, strides);
    }

    /** The surface of one part, closed and facing outward; without triangles if there is no such part. */
    public TriangleMesh surface(int part) {
        int wanted = 0;
        for (short side : sides) {
            wanted += side == part ? 1 : 0;
        }
        // A net may have millions of faces, of which a rib has a few thousand.
        int[] own = new int[4 * wanted];
        long[] voxels = new long[wanted];
        int count = 0;
        for (int q = 0; q < faces.length; q++) {
            boolean first = sides[2 * q] == part;
            if (first || sides[2 * q + 1] == part) {
                for (int corner = 0; corner < 4; corner++) {
                    own[4 * count + corner] = quads[4 * q + (first ? corner : 3 - corner)];
                }
                long voxel = faces[q] / 3;
                voxels[count++] = first ? voxel : voxel + strides[(int) (faces[q] % 3)];
            }
        }
        return new QuadStitcher(positions, own, voxels).mesh();
    }
}
