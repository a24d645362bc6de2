package org.phrenic.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/**
 * The soft tissue of the wall or of the abdomen: the {@link HarmonicExtension} of the displacements of the surfaces
 * that lie in it. The wall slides along the lungs and, in the mediastinum, the diaphragm, the abdomen along the
 * diaphragm. Below the diaphragm the abdomen slides up and down along the wall, which holds it horizontally.
 *
 * <p>Tissue neither leaves the face along which it slides nor enters it. A first solution has a border without gradient
 * there. A second one also holds, at each vertex of the face, the place on the moved face that is nearest to where the
 * first one carries that vertex; the tissue slides by the distance between that place and the vertex.
 */
final class SoftTissue {
    /** Edge of the lattice, mm. */
    static final double EDGE_MM = 6;
    /**
     * Edges over which the displacement of the wall fades outside the body, after three edges. At the next node it is
     * 0. As its own nodes reach up to one edge beyond the skin, these are 14 edges ({@link BodyMotion#OUTSIDE_MM}).
     */
    private static final int FADED_LAYERS = 9;

    private static final double MARGIN_MM = BodyMotion.OUTSIDE_MM;
    /** Nodes of the abdomen at the wall stay beside it where the diaphragm is farther away than this, mm. */
    private static final double BELOW_DIAPHRAGM_MM = 2 * EDGE_MM;

    private final List<Surface> surfaces;
    private final VectorLattice lattice;
    private final int[] moving;
    private final TriangleMesh merged;
    private final SurfaceFollower follower;
    private final List<SlidingFace> faces;
    private final int[] borderNodes;
    private final HarmonicExtension free;
    private final HarmonicExtension closed;
    private double[] now;

    private SoftTissue(
            List<Surface> surfaces, BodyRegions regions, byte[] labels, VectorLattice lattice, int soft, int[] border) {
        this.surfaces = surfaces;
        this.lattice = lattice;
        borderNodes = border;
        moving = IntStream.range(0, surfaces.size())
                .filter(i -> regions.moves(i, soft))
                .toArray();
        merged = merge();
        follower = new SurfaceFollower(merged, EDGE_MM);
        now = merged.positions();
        boolean wall = soft == BodyRegions.WALL;
        faces = regions.slidingFaces(soft);
        boolean[] own = new boolean[labels.length];
        for (int node = 0; node < labels.length; node++) {
            own[node] = regions.belongs(Byte.toUnsignedInt(labels[node]), soft);
        }
        boolean[] active = lattice.dilated(own);
        DoubleList places = new DoubleList();
        DoubleList areas = new DoubleList();
        for (int m : moving) {
            add(surfaces.get(m).rest(), places, areas);
        }
        for (int node : border) {
            for (int axis = 0; axis < 3; axis++) {
                places.add(lattice.place(node, axis));
            }
            areas.add(EDGE_MM * EDGE_MM);
        }
        int faded = wall ? FADED_LAYERS : 0;
        free = new HarmonicExtension(lattice, active, places.toArray(), areas.toArray(), border.length, faded);
        // Those that hold the horizontal components alone have to come last.
        DoubleList withFaces = new DoubleList();
        DoubleList theirAreas = new DoubleList();
        for (SlidingFace face : faces) {
            add(face.rest(), withFaces, theirAreas);
        }
        for (int k = 0; k < places.size(); k++) {
            withFaces.add(places.get(k));
        }
        for (int k = 0; k < areas.size(); k++) {
            theirAreas.add(areas.get(k));
        }
        closed =
                new HarmonicExtension(lattice, active, withFaces.toArray(), theirAreas.toArray(), border.length, faded);
    }

    /** Wall and abdomen of a body on the same lattice. */
    static SoftTissue[] of(List<Surface> surfaces, BodyRegions regions) {
        VectorLattice wall = VectorLattice.covering(Surface.bounds(surfaces), MARGIN_MM, EDGE_MM);
        List<double[]> rest = surfaces.stream().map(s -> s.rest().positions()).toList();
        byte[] labels = regions.label(wall.box(), rest);
        SoftTissue outer = new SoftTissue(surfaces, regions, labels, wall, BodyRegions.WALL, new int[0]);
        VectorLattice abdomen = new VectorLattice(wall.low, wall.size, wall.edge);
        int[] border = border(surfaces, labels, wall);
        return new SoftTissue[] {outer, new SoftTissue(surfaces, regions, labels, abdomen, BodyRegions.ABDOMEN, border)
        };
    }

    /** Nodes of the abdomen beside the wall and away from the diaphragm. */
    private static int[] border(List<Surface> surfaces, byte[] labels, VectorLattice lattice) {
        IntList border = new IntList();
        List<TriangleTree> diaphragm = new ArrayList<>();
        for (Surface s : surfaces) {
            if (s.kind() == StructureKind.DIAPHRAGM) {
                diaphragm.add(new TriangleTree(s.rest()));
            }
        }
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int node = 0; node < labels.length; node++) {
            boolean beside = false;
            for (int side = 0; side < 6 && labels[node] == BodyRegions.ABDOMEN; side++) {
                int other = lattice.neighbour(node, side);
                beside |= other >= 0 && labels[other] == BodyRegions.WALL;
            }
            double x = lattice.place(node, 0);
            double y = lattice.place(node, 1);
            double z = lattice.place(node, 2);
            if (beside && diaphragm.stream().noneMatch(t -> t.closest(x, y, z, BELOW_DIAPHRAGM_MM, hit))) {
                border.add(node);
            }
        }
        return border.toArray();
    }

    private static void add(TriangleMesh mesh, DoubleList places, DoubleList areas) {
        for (double coordinate : mesh.positions()) {
            places.add(coordinate);
        }
        for (double area : MeshMeasure.vertexAreas(mesh)) {
            areas.add(area);
        }
    }

    /** All moving surfaces as one mesh. */
    private TriangleMesh merge() {
        DoubleList p = new DoubleList();
        IntList t = new IntList();
        for (int m : moving) {
            TriangleMesh mesh = surfaces.get(m).rest();
            int first = p.size() / 3;
            for (double coordinate : mesh.positions()) {
                p.add(coordinate);
            }
            for (int corner : mesh.triangles()) {
                t.add(first + corner);
            }
        }
        return new TriangleMesh(p.toArray(), t.toArray());
    }

    /**
     * Takes the positions of all surfaces now.
     *
     * @param wall the wall in the same state, which holds the abdomen where there is no diaphragm between; for the wall
     *     itself any lattice
     */
    void update(List<double[]> positions, VectorLattice wall) {
        DoubleList displacements = new DoubleList();
        DoubleList all = new DoubleList();
        for (int m = 0; m < moving.length; m++) {
            double[] rest = surfaces.get(moving[m]).rest().positions();
            double[] at = positions.get(moving[m]);
            for (double coordinate : at) {
                all.add(coordinate);
            }
            for (int k = 0; k < at.length; k++) {
                displacements.add(at[k] - rest[k]);
            }
        }
        for (int node : borderNodes) {
            for (int k = 3 * node; k < 3 * node + 3; k++) {
                displacements.add(wall.vectors[k]);
            }
        }
        now = all.toArray();
        Arrays.fill(lattice.vectors, 0);
        free.solve(displacements.toArray());
        DoubleList withFaces = new DoubleList();
        for (SlidingFace face : faces) {
            face.add(lattice, positions.get(face.surface()), withFaces);
        }
        for (int k = 0; k < displacements.size(); k++) {
            withFaces.add(displacements.get(k));
        }
        closed.solve(withFaces.toArray());
    }

    VectorLattice lattice() {
        return lattice;
    }

    /** The field that is exact on the surfaces. */
    RegionField exact() {
        return follower.exact(lattice, now);
    }
}
