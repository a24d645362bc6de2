package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** Organs, and what lies in the liver and on bones, of the inspired man of {@link EndExpirationTest}. */
class EndExpirationContentsTest {
    /** Vertex of rib 7 at which a lesion lies. */
    private static final int ON_RIB = 200;

    private static final String FLUID = "other_Pleural_Effusion";
    private static final PatientBody SCANNED = scanned();
    private static final PatientBody RESTING = EndExpiration.of(
                    SCANNED, EndExpirationTest.INSPIRED, EndExpirationTest.LEVEL)
            .body();

    private static PatientBody scanned() {
        double[] liver = mesh(EndExpirationTest.INSPIRED, "liver").centre();
        double[] vertebra = mesh(EndExpirationTest.INSPIRED, "vertebra_T11").centre();
        double[] rib = vertex(mesh(EndExpirationTest.INSPIRED, "rib_07_R"), ON_RIB);
        Map<String, double[]> places = new LinkedHashMap<>();
        places.put("hepatic_vein", liver);
        places.put("vessel_of_segment_4", liver);
        places.put("other_5", liver);
        places.put("other_nodule", mesh(EndExpirationTest.INSPIRED, "lung_R").centre());
        places.put("aorta", vertebra);
        places.put("other_9", vertebra);
        places.put("lesion_vertebra_t11_tumor", vertebra);
        places.put("lesion_bone_metastasis", vertebra);
        places.put("lesion_rib_7_metastasis_R", rib);
        List<PatientStructure> all = new ArrayList<>(EndExpirationTest.INSPIRED.structures());
        places.forEach((name, place) -> all.add(new PatientStructure(
                new Structure(name, kind(name), 0, Side.MIDLINE, tetrahedron(place)),
                PatientStructure.Source.SCAN,
                Optional.empty(),
                Optional.empty())));
        all.add(organ("heart", 0.55, 0.4, 60));
        PatientStructure fluid = organ(FLUID, 0.3, 0.6, 15);
        all.add(fluid.withStructure(new Structure(
                FLUID, StructureKind.OTHER, 0, Side.MIDLINE, fluid.structure().mesh())));
        all.add(organ("spleen", 0.8, 0.8, -60));
        all.add(organ("kidney_L", 0.65, 0.8, -100));
        all.add(organ("kidney_R", 0.35, 0.8, -170));
        all.add(organ("organ_kidneys", 0.35, 0.8, -170));
        return new PatientBody("patient", all, List.of(), List.of());
    }

    /** A ball at a share of the breadth and depth of the lungs, and in mm above the top of the liver. */
    private static PatientStructure organ(String name, double breadth, double depth, double above) {
        double[] right = mesh(EndExpirationTest.INSPIRED, "lung_R").bounds();
        double[] left = mesh(EndExpirationTest.INSPIRED, "lung_L").bounds();
        TriangleMesh ball = Shapes.moved(
                Shapes.sphere(30, 3),
                right[0] + breadth * (left[3] - right[0]),
                right[1] + depth * (right[4] - right[1]),
                mesh(EndExpirationTest.INSPIRED, "liver").bounds()[5] + above);
        return new PatientStructure(
                new Structure(name, StructureKind.ORGAN, 0, Side.MIDLINE, ball),
                PatientStructure.Source.SCAN,
                Optional.empty(),
                Optional.empty());
    }

    private static StructureKind kind(String name) {
        return name.startsWith("other")
                ? StructureKind.OTHER
                : name.startsWith("lesion") ? StructureKind.LESION : StructureKind.VESSEL;
    }

    private static TriangleMesh tetrahedron(double[] p) {
        double[] corners = {p[0], p[1], p[2], p[0] + 1, p[1], p[2], p[0], p[1] + 1, p[2], p[0], p[1], p[2] + 1};
        return new TriangleMesh(corners, new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
    }

    private static TriangleMesh mesh(PatientBody body, String name) {
        return body.structure(name).orElseThrow().structure().mesh();
    }

    private static double[] vertex(TriangleMesh mesh, int v) {
        return new double[] {mesh.x(v), mesh.y(v), mesh.z(v)};
    }

    /** Vessels of the liver in a scan whose liver has no label, and all in one that has. */
    @Test
    void vesselsAndUnknownStructuresInTheLiverRiseWithIt() {
        TriangleTree liver = new TriangleTree(mesh(RESTING, "liver"));
        for (String name : List.of("hepatic_vein", "vessel_of_segment_4", "other_5")) {
            double[] before = vertex(mesh(SCANNED, name), 0);
            double[] after = vertex(mesh(RESTING, name), 0);
            assertThat(after[2] - before[2]).as(name).isGreaterThan(0.5 * EndExpirationTest.LEVEL.descentMm());
            assertThat(liver.isInside(after[0], after[1], after[2])).as(name).isTrue();
        }
        PatientBody noLiver = new PatientBody(
                "patient",
                SCANNED.structures().stream()
                        .filter(s -> s.structure().kind() != StructureKind.LIVER)
                        .toList(),
                List.of(),
                List.of());
        PatientBody resting = EndExpiration.of(noLiver, EndExpirationTest.INSPIRED, EndExpirationTest.LEVEL)
                .body();
        double rise = mesh(resting, "hepatic_vein").bounds()[2]
                - mesh(SCANNED, "hepatic_vein").bounds()[2];
        assertThat(rise).isGreaterThan(0.5 * EndExpirationTest.LEVEL.descentMm());
    }

    /** Fluid below the right lung, and an unknown structure within it. */
    @Test
    void whatLiesInTheChestRisesWithTheLung() {
        double[] fluid = mesh(SCANNED, FLUID).centre();
        assertThat(mesh(RESTING, FLUID).centre()[2] - fluid[2])
                .isGreaterThan(0.7 * EndExpirationTest.LEVEL.descentMm());
        TriangleTree lung = new TriangleTree(mesh(RESTING, "lung_R"));
        double[] nodule = vertex(mesh(RESTING, "other_nodule"), 0);
        assertThat(nodule[2]).isGreaterThan(mesh(SCANNED, "other_nodule").z(0) + 5);
        assertThat(lung.isInside(nodule[0], nodule[1], nodule[2])).isTrue();
    }

    /** A ball that the dome of the virtual man passes through, and balls above and below it. */
    @Test
    void unknownStructuresOnBothSidesOfTheDiaphragmAreNamed() {
        Thorax man = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        double[] liver = man.find("liver").orElseThrow().mesh().bounds();
        List<Structure> all = new ArrayList<>(man.structures());
        double x = 0.6 * liver[0] + 0.4 * liver[3];
        double y = 0.5 * (liver[1] + liver[4]);
        assertThat(UnknownSides.note(man)).isEmpty();
        for (int offset : new int[] {-50, 50}) {
            TriangleMesh ball = Shapes.moved(Shapes.sphere(20, 3), x, y, liver[5] + offset);
            all.add(new Structure("other_" + offset, StructureKind.OTHER, 0, Side.MIDLINE, ball));
        }
        assertThat(UnknownSides.note(new Thorax("man", all, List.of()))).isEmpty();
        TriangleMesh through = Shapes.moved(Shapes.sphere(20, 3), x, y, liver[5]);
        all.add(new Structure("other_1", StructureKind.OTHER, 0, Side.MIDLINE, through));
        assertThat(UnknownSides.note(new Thorax("man", all, List.of()))).hasValueSatisfying(note -> assertThat(note)
                .contains("pass through or lie on both sides of the diaphragm", ": other_1 ("));
    }

    @Test
    void organsThatAreNoBagsKeepTheirVolume() {
        for (String name : List.of("heart", "spleen", "kidney_R", "kidney_L", "organ_kidneys")) {
            TriangleMesh before = mesh(SCANNED, name);
            TriangleMesh after = mesh(RESTING, name);
            assertThat(after.centre()[2] - before.centre()[2]).as(name).isGreaterThan(5);
            assertThat(MeshMeasure.signedVolume(after) / MeshMeasure.signedVolume(before))
                    .as(name)
                    .isCloseTo(1, within(1e-9));
        }
    }

    @Test
    void greatVesselsAndUnknownStructuresElsewhereKeepTheirPlaces() {
        for (String name : List.of("aorta", "other_9")) {
            assertThat(mesh(RESTING, name).positions())
                    .as(name)
                    .isEqualTo(mesh(SCANNED, name).positions());
        }
    }

    @Test
    void lesionsOfVertebraeStayAndThoseOfRibsTurnWithTheirRib() {
        for (String name : List.of("lesion_vertebra_t11_tumor", "lesion_bone_metastasis")) {
            assertThat(mesh(RESTING, name).positions())
                    .as(name)
                    .isEqualTo(mesh(SCANNED, name).positions());
        }
        double[] rib = vertex(mesh(RESTING, "rib_07_R"), ON_RIB);
        assertThat(rib).isNotEqualTo(vertex(mesh(SCANNED, "rib_07_R"), ON_RIB));
        assertThat(vertex(mesh(RESTING, "lesion_rib_7_metastasis_R"), 0)).containsExactly(rib, within(1e-9));
    }
}
