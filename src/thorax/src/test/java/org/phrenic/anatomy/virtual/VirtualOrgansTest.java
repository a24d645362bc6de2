package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/** Volumes and places of the organs of the virtual bodies against ICRP Publication 89 and textbooks of anatomy. */
class VirtualOrgansTest {
    private static final int T11 = 11;
    private static final int T12 = 12;
    private static final int L1 = 13;
    private static final int L2 = 14;
    private static final int L3 = 15;

    private static Thorax body(String preset) {
        return VirtualThorax.ofPreset(preset, Resolution.LOW);
    }

    private static Spine spine(String preset) {
        return new Spine(VirtualThoraxParameters.preset(preset).spine());
    }

    private static TriangleMesh mesh(Thorax body, String name) {
        return body.organs().get().stream()
                .filter(s -> s.name().equals(name))
                .findFirst()
                .orElseThrow()
                .mesh();
    }

    private static double volumeMl(Thorax body, String name) {
        return MeshMeasure.signedVolume(mesh(body, name)) / 1000;
    }

    /** Mean of a coordinate over chosen vertices. */
    private static double mean(TriangleMesh mesh, int axis, IntPredicate chosen) {
        return IntStream.range(0, mesh.vertexCount())
                .filter(chosen)
                .mapToDouble(v -> mesh.positions()[3 * v + axis])
                .average()
                .orElseThrow();
    }

    private static double mean(TriangleMesh mesh, int axis) {
        return mean(mesh, axis, v -> true);
    }

    /** Masses in g of ICRP Publication 89, adult man and woman, contents included, divided by their density. */
    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void volumesAreThoseOfTheReferenceAdultWithinThirtyPercent(String preset) {
        Thorax body = body(preset);
        boolean man = preset.equals("adult-male");
        Percentage third = Percentage.withPercentage(30);
        assertThat(volumeMl(body, "spleen")).isCloseTo((man ? 150 : 130) / 1.06, third);
        assertThat(volumeMl(body, "kidney_R")).isCloseTo((man ? 155 : 138) / 1.05, third);
        assertThat(volumeMl(body, "kidney_L")).isCloseTo((man ? 155 : 138) / 1.05, third);
        assertThat(volumeMl(body, "pancreas")).isCloseTo((man ? 140 : 120) / 1.05, third);
        assertThat(volumeMl(body, "gallbladder")).isCloseTo((man ? 68 : 56) / 1.03, third);
        assertThat(volumeMl(body, "stomach")).isCloseTo((man ? 400 : 370) / 1.04, third);
        // 25 of 280 cm of small intestine.
        assertThat(volumeMl(body, "duodenum")).isCloseTo((man ? 1000 : 880) / 1.04 * 25 / 280, third);
        // 66 of 96 cm: without caecum, lower half of the ascending and last third of the descending colon.
        assertThat(volumeMl(body, "colon")).isCloseTo((man ? 525 : 530) / 1.04 * 66 / 96, third);
        // Muscle and the blood of its chambers.
        assertThat(volumeMl(body, "heart")).isCloseTo((man ? 840 : 620) / 1.06, third);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void kidneysPancreasAndVesselsLieAtTheirVertebrae(String preset) {
        Thorax body = body(preset);
        Spine spine = spine(preset);
        double[] right = mesh(body, "kidney_R").bounds();
        double[] left = mesh(body, "kidney_L").bounds();
        assertThat(right[5]).isBetween(spine.bodyZ(L1) - 5, spine.bodyZ(T11));
        assertThat(left[5]).isBetween(spine.bodyZ(L1), spine.bodyZ(T11));
        assertThat(right[2]).isBetween(spine.bodyZ(L3) - 30, spine.bodyZ(L2));
        assertThat(left[2]).isBetween(spine.bodyZ(L3) - 20, spine.bodyZ(L2));
        assertThat(right[2]).isBetween(left[2] - 25, left[2] - 8);
        assertThat(mean(mesh(body, "kidney_R"), 1)).isGreaterThan(spine.frontY(spine.bodyZ(L2)) - 10);
        TriangleMesh pancreas = mesh(body, "pancreas");
        assertThat(pancreas.bounds()[0]).isBetween(-60.0, -30.0);
        assertThat(pancreas.bounds()[3]).isGreaterThan(60);
        assertThat(mean(pancreas, 2, v -> Math.abs(pancreas.x(v)) < 12)).isBetween(spine.bodyZ(L2), spine.bodyZ(T12));
        TriangleMesh aorta = mesh(body, "aorta");
        TriangleMesh cava = mesh(body, "inferior_vena_cava");
        assertThat(mean(aorta, 0, v -> aorta.z(v) < spine.bodyZ(T12))).isBetween(3.0, 15.0);
        assertThat(mean(cava, 0)).isBetween(-30.0, -12.0);
        double z = spine.bodyZ(L2);
        assertThat(breadth(aorta, z)).isBetween(16.0, 24.0);
        assertThat(breadth(cava, z)).isBetween(18.0, 26.0);
    }

    /**
     * Cardiothoracic ratio of adults 0.42 to 0.50; two thirds of the heart left of the midline; behind the lower
     * sternum; apex behind the fifth intercostal space and its borders, about the midclavicular line, 70 to 90 mm to
     * the left.
     */
    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void theHeartLiesBehindTheLowerSternumWithItsApexInTheFifthSpace(String preset) {
        Thorax body = body(preset);
        TriangleMesh heart = mesh(body, "heart");
        double[] box = heart.bounds();
        double chest = body.find("lung_L").orElseThrow().mesh().bounds()[3]
                - body.find("lung_R").orElseThrow().mesh().bounds()[0];
        assertThat((box[3] - box[0]) / chest).isBetween(0.42, 0.5);
        assertThat(box[3] / (box[3] - box[0])).isBetween(0.6, 0.75);
        double[] sternum = body.find("sternum_body").orElseThrow().mesh().bounds();
        assertThat(mean(heart, 2)).isBetween(sternum[2], sternum[5]);
        assertThat(mean(heart, 1)).isGreaterThan(sternum[4]);
        int apex = IntStream.range(0, heart.vertexCount())
                .boxed()
                .max((a, b) -> Double.compare(towardApex(heart, a), towardApex(heart, b)))
                .orElseThrow();
        assertThat(heart.x(apex)).isBetween(70.0, 90.0);
        assertThat(heart.z(apex)).isBetween(cartilageZ(body, 6, heart.x(apex)), cartilageZ(body, 4, heart.x(apex)));
    }

    /** How far a vertex lies to the left, front and feet. */
    private static double towardApex(TriangleMesh heart, int v) {
        return 0.8 * heart.x(v) - 0.45 * heart.y(v) - 0.4 * heart.z(v);
    }

    private static double cartilageZ(Thorax body, int level, double x) {
        TriangleMesh mesh = body.find(StructureKind.COSTAL_CARTILAGE, level, Side.LEFT)
                .orElseThrow()
                .mesh();
        return mean(mesh, 2, v -> Math.abs(mesh.x(v) - x) < 8);
    }

    private static double breadth(TriangleMesh mesh, double z) {
        double[] x = IntStream.range(0, mesh.vertexCount())
                .filter(v -> Math.abs(mesh.z(v) - z) < 8)
                .mapToDouble(mesh::x)
                .toArray();
        return Arrays.stream(x).max().orElseThrow() - Arrays.stream(x).min().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void stomachSpleenGallbladderAndColonLieAboutLiverAndDomes(String preset) {
        Thorax body = body(preset);
        TriangleTree liver = new TriangleTree(body.find("liver").orElseThrow().mesh());
        TriangleMesh gallbladder = mesh(body, "gallbladder");
        assertThat(nearest(liver, gallbladder)).isBetween(0.0, 4.0);
        assertThat(mean(gallbladder, 0)).isBetween(-70.0, -25.0);
        TriangleMesh colon = mesh(body, "colon");
        double flexure = IntStream.range(0, colon.vertexCount())
                .filter(v -> colon.x(v) < -50)
                .mapToDouble(colon::z)
                .max()
                .orElseThrow();
        double splenic = IntStream.range(0, colon.vertexCount())
                .filter(v -> colon.x(v) > 50)
                .mapToDouble(colon::z)
                .max()
                .orElseThrow();
        assertThat(flexure).isBetween(-60.0, -15.0);
        assertThat(splenic).isGreaterThan(flexure + 20);
        double[] dome =
                VirtualThoraxParameters.preset(preset).diaphragm().left().toArray();
        TriangleMesh stomach = mesh(body, "stomach");
        assertThat(dome[2] - stomach.bounds()[5]).isBetween(2.0, 20.0);
        assertThat(mean(stomach, 0)).isGreaterThan(20);
        assertThat(stomach.bounds()[0]).isBetween(-30.0, -5.0);
        TriangleMesh spleen = mesh(body, "spleen");
        double[] centre = {mean(spleen, 0), mean(spleen, 1), mean(spleen, 2)};
        Structure rib = body.structuresOf(StructureKind.RIB).stream()
                .filter(s -> s.side() == Side.LEFT)
                .min((a, b) -> Double.compare(distance(a, centre), distance(b, centre)))
                .orElseThrow();
        assertThat(rib.level()).isBetween(9, 11);
        assertThat(centre[1]).isGreaterThan(5);
    }

    private static double distance(Structure s, double[] p) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        new TriangleTree(s.mesh()).closest(p[0], p[1], p[2], hit);
        return hit.distanceSquared;
    }

    private static double nearest(TriangleTree tree, TriangleMesh mesh) {
        return Arrays.stream(tree.distances(mesh.positions())).min().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void vesselsOfTheWallRunBesideSternumAndMidline(String preset) {
        Thorax body = body(preset);
        double sternum = body.find("sternum_body").orElseThrow().mesh().bounds()[3];
        TriangleMesh mammary = mesh(body, "internal_mammary_vessels_L");
        double z = mean(mammary, 2);
        assertThat(mean(mammary, 0, v -> mammary.z(v) < z)).isCloseTo(sternum + 10, within(4.0));
        TriangleMesh epigastric = mesh(body, "superior_epigastric_vessels_R");
        assertThat(epigastric.bounds()[0]).isGreaterThan(-50);
        assertThat(epigastric.bounds()[3]).isLessThan(-26);
        assertThat(epigastric.bounds()[5]).isLessThan(70);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void thePleuraIsReflectedAtRibsEightTenAndTwelve(String preset) {
        Thorax body = body(preset);
        TriangleMesh pleura = mesh(body, "pleura_R");
        assertThat(MeshMeasure.openness(pleura)).isGreaterThan(0.1);
        // Azimuth from the back about the middle of the trunk: midclavicular, midaxillary and paravertebral line.
        assertThat(lowest(pleura, 128) - atAzimuth(body, 8, 122)).isCloseTo(0, within(14.0));
        assertThat(lowest(pleura, 88) - atAzimuth(body, 10, 88)).isCloseTo(0, within(12.0));
        assertThat(lowest(pleura, 34) - atAzimuth(body, 12, 34)).isCloseTo(0, within(12.0));
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void noTriangleOfThePleuraFoldsBackOntoItsNeighbour(String preset) {
        for (String name : List.of("pleura_R", "pleura_L")) {
            TriangleMesh pleura = mesh(body(preset), name);
            EdgeTable edges = new EdgeTable(pleura);
            double[] normals = MeshMeasure.triangleNormals(pleura);
            double least = IntStream.range(0, edges.edgeCount())
                    .filter(edge -> edges.faceCount(edge) == 2)
                    .mapToDouble(edge -> Vectors.dot(
                            Arrays.copyOfRange(normals, 3 * edges.face(edge, 0), 3 * edges.face(edge, 0) + 3),
                            Arrays.copyOfRange(normals, 3 * edges.face(edge, 1), 3 * edges.face(edge, 1) + 3)))
                    .min()
                    .orElseThrow();
            assertThat(least).as("least cosine between neighbours of %s", name).isPositive();
        }
    }

    private static boolean isAt(TriangleMesh mesh, int v, double azimuthDeg) {
        double azimuth = Math.toDegrees(Math.atan2(-mesh.x(v), mesh.y(v) + 25));
        return Math.abs(azimuth - azimuthDeg) < 5;
    }

    private static double lowest(TriangleMesh mesh, double azimuthDeg) {
        return IntStream.range(0, mesh.vertexCount())
                .filter(v -> isAt(mesh, v, azimuthDeg))
                .mapToDouble(mesh::z)
                .min()
                .orElseThrow();
    }

    private static double atAzimuth(Thorax body, int rib, double azimuthDeg) {
        TriangleMesh mesh =
                body.find(StructureKind.RIB, rib, Side.RIGHT).orElseThrow().mesh();
        return mean(mesh, 2, v -> isAt(mesh, v, azimuthDeg));
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void noOrganIsOpenEmptyOrInAnother(String preset) {
        Thorax body = body(preset);
        List<Structure> organs = body.organs().get().stream()
                .filter(s -> s.kind() == StructureKind.ORGAN || s.kind() == StructureKind.VESSEL)
                .toList();
        List<TriangleTree> trees =
                organs.stream().map(s -> new TriangleTree(s.mesh())).toList();
        assertThat(organs).hasSize(21);
        for (int i = 0; i < organs.size(); i++) {
            assertThat(MeshMeasure.openness(organs.get(i).mesh()))
                    .as(organs.get(i).name())
                    .isLessThan(1e-9);
            assertThat(MeshMeasure.signedVolume(organs.get(i).mesh())).isGreaterThan(500);
            for (int j = 0; j < organs.size(); j++) {
                if (i != j) {
                    assertThat(verticesInside(organs.get(i).mesh(), trees.get(j)))
                            .as(organs.get(i).name() + " in " + organs.get(j).name())
                            .isZero();
                }
            }
        }
    }

    private static int verticesInside(TriangleMesh mesh, TriangleTree tree) {
        double[] box = tree.mesh().bounds();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int inside = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            double x = mesh.x(v);
            double y = mesh.y(v);
            double z = mesh.z(v);
            boolean near = x > box[0] && y > box[1] && z > box[2] && x < box[3] && y < box[4] && z < box[5];
            if (near && tree.countAlongRay(x, y, z, 0.0123, 0.0371, 1, hit) % 2 == 1) {
                inside++;
            }
        }
        return inside;
    }
}
