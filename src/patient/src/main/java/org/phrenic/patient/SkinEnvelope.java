package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * The skin of a body whose scan has none: a smooth envelope of the bones and organs of the trunk ({@link TrunkParts}).
 *
 * <p>The structures are dilated by {@value #RADIUS_MM} mm and eroded by {@value #RADIUS_MM} - {@value #WALL_MM} mm
 * ({@link SurfaceEnvelope}, with distances in a grid of {@value #CELL_MM} mm). The result contains every structure of
 * the trunk with a margin, bridges gaps such as intercostal spaces, and has no fold. Where a body has no structures,
 * elliptic sections take their place: of an adult's size in the neck, as broad as the lower rib cage in an abdomen
 * without bowel.
 */
public final class SkinEnvelope {
    /** Name of the structure. */
    public static final String NAME = "skin_torso";
    /** Thickness of the body wall outside bones and organs, mm. */
    static final double WALL_MM = 15;

    private static final double RADIUS_MM = 60;
    private static final double CELL_MM = 5;
    private static final double EDGE_MM = 9;

    private SkinEnvelope() {}

    /**
     * Returns the body with a skin around it. A skin of the scan is kept if it reaches as high and as low as the ribs
     * and farther than they to every side, unlike that of a field of view narrower than the completed cage; otherwise
     * the envelope contains it. A body without ribs is returned as it is.
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
        Optional<double[]> ribs = PatientBody.bounds(inside.stream().filter(s -> s.kind() == StructureKind.RIB));
        Optional<double[]> skin = PatientBody.bounds(skins.stream());
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
                .withNotes(List.of(note(!skins.isEmpty())));
    }

    private static String note(boolean isShown) {
        return Numbers.format(
                "the skin is a smooth envelope of bones and organs, %.0f mm outside them%s",
                WALL_MM, isShown ? ", and of the skin that the scan shows" : "");
    }

    private static boolean contains(double[] skin, double[] ribs) {
        boolean around = skin[0] < ribs[0] && skin[3] > ribs[3] && skin[1] < ribs[1] && skin[4] > ribs[4];
        return around && skin[2] < ribs[2] + WALL_MM && skin[5] > ribs[5] - WALL_MM;
    }

    /** The surface moved inward by the thickness of the wall. */
    private static TriangleMesh shrunk(TriangleMesh skin) {
        double[] normals = MeshMeasure.vertexNormals(skin);
        double[] p = skin.positions().clone();
        Arrays.setAll(p, i -> p[i] - WALL_MM * normals[i]);
        return skin.withPositions(p);
    }

    /** A closed surface around the trunk of a body. */
    static TriangleMesh around(List<Structure> body) {
        List<Structure> structures = TrunkParts.of(body);
        List<TrunkSection> sections = TrunkSection.of(structures);
        double[] box = PatientBody.merged(structures.stream()).orElseThrow().bounds();
        for (TrunkSection s : sections) {
            box[2] = Math.min(box[2], s.z());
            box[5] = Math.max(box[5], s.z());
        }
        SurfaceEnvelope envelope = new SurfaceEnvelope(box, RADIUS_MM, CELL_MM);
        envelope.mark(structures.stream().map(Structure::mesh).toList());
        sections.forEach(s -> mark(s, envelope));
        return envelope.closed(RADIUS_MM, WALL_MM, EDGE_MM);
    }

    /** Marks the cells of a section and all within: an outline alone would leave the body hollow at its lower end. */
    private static void mark(TrunkSection s, SurfaceEnvelope envelope) {
        int half = (int) Math.ceil(Math.max(s.a(), s.b()) / CELL_MM);
        for (int row = -half; row <= half; row++) {
            for (int column = -half; column <= half; column++) {
                double dx = column * CELL_MM;
                double dy = row * CELL_MM;
                if (dx * dx / (s.a() * s.a()) + dy * dy / (s.b() * s.b()) <= 1) {
                    envelope.mark(s.x() + dx, s.y() + dy, s.z());
                }
            }
        }
    }
}
