package org.phrenic.motion;

import java.util.Arrays;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.CappedSurface;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.simulation.observe.Surface;

/**
 * The inside of a closed surface that deforms; holes are closed ({@link CappedSurface}). Its displacement is the
 * {@link HarmonicExtension} of that of its vertices, or that of a {@link SlidingElasticSolid}, which takes only the
 * shape of the moved surface.
 */
final class ClosedRegion {
    private static final double GREATEST_EDGE_MM = 6;
    private static final double LEAST_EDGE_MM = 3;
    /** Edges along the cube root of the volume. */
    private static final double EDGES = 8;

    private static final double MARGIN_EDGES = 5;

    private final TriangleMesh rest;
    private final boolean elastic;
    private final VectorLattice lattice;
    private final boolean[] active;
    private final HarmonicExtension extension;
    private final SurfaceFollower follower;
    private SlidingElasticSolid solid;
    private double[] now;

    /** @param elastic whether the inside is an elastic solid whose surface slides */
    ClosedRegion(Surface surface, boolean elastic) {
        rest = surface.rest();
        this.elastic = elastic;
        TriangleMesh capped = new CappedSurface(rest).at(rest.positions());
        double volume = Math.abs(MeshMeasure.signedVolume(capped));
        double edge = Math.max(LEAST_EDGE_MM, Math.min(GREATEST_EDGE_MM, StrictMath.cbrt(volume) / EDGES));
        lattice = VectorLattice.covering(rest.bounds(), MARGIN_EDGES * edge, edge);
        active = lattice.dilated(inside(capped));
        extension = new HarmonicExtension(lattice, active, rest.positions(), MeshMeasure.vertexAreas(rest), 0, 0);
        follower = new SurfaceFollower(rest, edge);
        now = rest.positions();
    }

    /** Nodes inside the surface without holes, and the corners of the cells that hold the vertices of the region's. */
    private boolean[] inside(TriangleMesh capped) {
        byte[] labels = new byte[lattice.nodes()];
        new MeshVoxelizer(
                        lattice.size[0],
                        lattice.size[1],
                        lattice.size[2],
                        lattice.box().toVoxel(),
                        labels)
                .fill(capped, 1);
        boolean[] inside = new boolean[labels.length];
        for (int node = 0; node < labels.length; node++) {
            inside[node] = labels[node] == 1;
        }
        double[] share = new double[3];
        for (int v = 0; v < rest.vertexCount(); v++) {
            int cell = lattice.cell(rest.x(v), rest.y(v), rest.z(v), share);
            for (int c = 0; c < 8; c++) {
                inside[lattice.corner(cell, c)] = true;
            }
        }
        return inside;
    }

    /** Takes the positions of the vertices now. */
    void update(double[] positions) {
        now = positions.clone();
        double[] displacement = new double[now.length];
        Arrays.setAll(displacement, k -> now[k] - rest.positions()[k]);
        Arrays.fill(lattice.vectors, 0);
        if (!elastic) {
            extension.solve(displacement);
            return;
        }
        TriangleMesh moved = rest.withPositions(now);
        double[] u = new double[3];
        solid = solid == null ? new SlidingElasticSolid(rest, moved) : solid.withSurface(moved);
        for (int node = 0; node < active.length; node++) {
            if (active[node]) {
                carriedBySolid(lattice.place(node, 0), lattice.place(node, 1), lattice.place(node, 2), u);
                System.arraycopy(u, 0, lattice.vectors, 3 * node, 3);
            }
        }
        extension.extend();
    }

    boolean isElastic() {
        return elastic;
    }

    VectorLattice lattice() {
        return lattice;
    }

    /** The field that is exact on the surface; of an elastic solid, whose surface slides, its own. */
    RegionField exact() {
        return elastic ? this::carriedBySolid : follower.exact(lattice, now);
    }

    private void carriedBySolid(double x, double y, double z, double[] out) {
        double[] place = {x, y, z};
        double[] at = solid.moved(place);
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = at[axis] - place[axis];
        }
    }
}
