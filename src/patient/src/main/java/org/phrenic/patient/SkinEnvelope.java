package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.DistanceTransform;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * The skin of a body whose scan has none: a smooth envelope of all bones and organs.
 *
 * <p>The structures are dilated by {@value #RADIUS_MM} mm and eroded by {@value #RADIUS_MM} - {@value #WALL_MM} mm
 * (morphological closing, with distances in a grid of {@value #CELL_MM} mm). The result contains every structure with a
 * margin, bridges gaps such as intercostal spaces, and has no fold. Where a body has no structures, in the neck and in
 * an abdomen without bowel, elliptic sections of its own proportions take their place.
 */
public final class SkinEnvelope {
    /** Name of the structure. */
    public static final String NAME = "skin_torso";
    /** Thickness of the body wall outside bones and organs, mm. */
    static final double WALL_MM = 15;

    private static final double RADIUS_MM = 60;
    private static final double CELL_MM = 5;
    private static final double EDGE_MM = 9;

    private final double[] low = new double[3];
    private final int[] size = new int[3];
    private final boolean[] marked;

    private SkinEnvelope(List<Structure> body) {
        List<TrunkSection> sections = TrunkSection.of(body);
        double[] box = PatientBody.merged(body.stream()).orElseThrow().bounds();
        for (TrunkSection s : sections) {
            box[2] = Math.min(box[2], s.z());
            box[5] = Math.max(box[5], s.z());
        }
        double margin = RADIUS_MM + 2 * CELL_MM;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = box[axis] - margin;
            size[axis] = (int) Math.ceil((box[3 + axis] - box[axis] + 2 * margin) / CELL_MM) + 1;
        }
        marked = new boolean[size[0] * size[1] * size[2]];
        body.forEach(s -> mark(s.mesh()));
        sections.forEach(this::mark);
    }

    /**
     * Returns the body with a skin around it. A skin of the scan is kept if it reaches as high and as low as the ribs;
     * otherwise the envelope contains it. A body without ribs is returned as it is.
     */
    public static PatientBody complete(PatientBody body) {
        List<Structure> inside = new ArrayList<>();
        List<Structure> skins = new ArrayList<>();
        for (PatientStructure s : body.structures()) {
            boolean skin = s.structure().kind() == StructureKind.SKIN;
            if (!skin || s.source() != PatientStructure.Source.VIRTUAL) {
                (skin ? skins : inside).add(s.structure());
            }
        }
        Optional<double[]> ribs = box(inside.stream().filter(s -> s.kind() == StructureKind.RIB));
        Optional<double[]> skin = box(skins.stream());
        boolean covered = skin.isPresent() && ribs.isPresent() && contains(skin.get(), ribs.get());
        if (ribs.isEmpty() || covered) {
            return body;
        }
        skins.forEach(s -> inside.add(s.withMesh(shrunk(s.mesh()))));
        List<PatientStructure> all = new ArrayList<>(body.structures());
        all.removeIf(s -> s.structure().kind() == StructureKind.SKIN);
        all.add(new PatientStructure(
                new Structure(NAME, StructureKind.SKIN, 0, Side.MIDLINE, around(inside)),
                PatientStructure.Source.BUILT,
                Optional.empty(),
                Optional.empty()));
        return new PatientBody(body.name(), all, ExpectedStructures.missing(all), body.notes())
                .withNotes(List.of(String.format(
                        Locale.ROOT,
                        "the skin is a smooth envelope of bones and organs, %.0f mm outside them",
                        WALL_MM)));
    }

    private static Optional<double[]> box(Stream<Structure> structures) {
        return PatientBody.merged(structures).map(TriangleMesh::bounds);
    }

    private static boolean contains(double[] skin, double[] ribs) {
        return skin[2] < ribs[2] + WALL_MM && skin[5] > ribs[5] - WALL_MM;
    }

    /** The surface moved inward by the thickness of the wall. */
    private static TriangleMesh shrunk(TriangleMesh skin) {
        double[] normals = MeshMeasure.vertexNormals(skin);
        double[] p = skin.positions().clone();
        Arrays.setAll(p, i -> p[i] - WALL_MM * normals[i]);
        return skin.withPositions(p);
    }

    /** A closed surface around structures. */
    static TriangleMesh around(List<Structure> structures) {
        return new SkinEnvelope(structures).mesh();
    }

    private TriangleMesh mesh() {
        float[] toStructures = DistanceTransform.of(marked, size);
        boolean[] outside = new boolean[marked.length];
        for (int cell = 0; cell < outside.length; cell++) {
            outside[cell] = toStructures[cell] * CELL_MM > RADIUS_MM;
        }
        float[] toOutside = DistanceTransform.of(outside, size);
        byte[] labels = new byte[marked.length];
        for (int cell = 0; cell < labels.length; cell++) {
            labels[cell] = (byte) (toOutside[cell] * CELL_MM > RADIUS_MM - WALL_MM ? 1 : 0);
        }
        double c = CELL_MM;
        LabelGrid grid = LabelGrid.of(
                size[0], size[1], size[2], labels, new double[] {c, 0, 0, low[0], 0, c, 0, low[1], 0, 0, c, low[2]});
        return new SegmentMesher(grid, new int[] {0, 1}, MeshingSettings.PAPER)
                .mesh(1, EDGE_MM)
                .mesh();
    }

    /** Marks the cells that a surface passes through. */
    private void mark(TriangleMesh mesh) {
        double[] p = mesh.positions();
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3) {
            double longest = 0;
            for (int k = 0; k < 3; k++) {
                longest = Math.max(longest, MeshMeasure.distance(mesh, t[i + k], t[i + (k + 1) % 3]));
            }
            int parts = Math.max(1, (int) Math.ceil(2 * longest / CELL_MM));
            for (int u = 0; u <= parts; u++) {
                for (int v = 0; v <= parts - u; v++) {
                    double wa = (double) u / parts;
                    double wb = (double) v / parts;
                    double wc = 1 - wa - wb;
                    int a = 3 * t[i];
                    int b = 3 * t[i + 1];
                    int c = 3 * t[i + 2];
                    mark(
                            wa * p[a] + wb * p[b] + wc * p[c],
                            wa * p[a + 1] + wb * p[b + 1] + wc * p[c + 1],
                            wa * p[a + 2] + wb * p[b + 2] + wc * p[c + 2]);
                }
            }
        }
    }

    private void mark(TrunkSection s) {
        int steps = (int) Math.ceil(2 * Math.PI * Math.max(s.a(), s.b()) / CELL_MM) * 2;
        for (int step = 0; step < steps; step++) {
            double angle = 2 * Math.PI * step / steps;
            mark(s.x() + s.a() * StrictMath.cos(angle), s.y() + s.b() * StrictMath.sin(angle), s.z());
        }
    }

    private void mark(double x, double y, double z) {
        int i = (int) Math.round((x - low[0]) / CELL_MM);
        int j = (int) Math.round((y - low[1]) / CELL_MM);
        int k = (int) Math.round((z - low[2]) / CELL_MM);
        boolean within = i >= 0 && i < size[0] && j >= 0 && j < size[1] && k >= 0 && k < size[2];
        if (within) {
            marked[i + size[0] * (j + size[1] * k)] = true;
        }
    }
}
