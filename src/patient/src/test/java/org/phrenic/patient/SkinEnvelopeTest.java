package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.SelfIntersections;
import org.phrenic.mesh.query.SurfaceDistance;

class SkinEnvelopeTest {
    private static PatientBody body(PatientStructure.Source ofSkin) {
        Thorax thorax = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        return new PatientBody(
                "body",
                thorax.structures().stream()
                        .map(s -> new PatientStructure(
                                s,
                                s.kind() == StructureKind.SKIN ? ofSkin : PatientStructure.Source.SCAN,
                                Optional.empty(),
                                Optional.empty()))
                        .toList(),
                List.of(),
                List.of());
    }

    private static TriangleMesh skin(PatientBody body) {
        List<Structure> skins = body.thorax().structuresOf(StructureKind.SKIN);
        assertThat(skins).hasSize(1);
        return skins.get(0).mesh();
    }

    @Test
    void theEnvelopeHoldsEveryStructureWithAMarginAndHasNoFold() {
        PatientBody grown = SkinEnvelope.complete(body(PatientStructure.Source.VIRTUAL));
        TriangleMesh skin = skin(grown);
        assertThat(grown.structure(SkinEnvelope.NAME).orElseThrow().source()).isEqualTo(PatientStructure.Source.BUILT);
        assertThat(grown.notes())
                .containsExactly("the skin is a smooth envelope of bones and organs, 15 mm outside them");
        MeshTopology topology = new MeshTopology(skin);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(2);
        assertThat(SelfIntersections.count(skin)).isZero();
        SurfaceDistance distance = new SurfaceDistance(skin);
        for (PatientStructure s : grown.structures()) {
            if (s.structure().kind() != StructureKind.SKIN) {
                double nearest = -Arrays.stream(
                                distance.signedDistance(s.structure().mesh().positions()))
                        .max()
                        .orElseThrow();
                assertThat(nearest).as(s.structure().name()).isGreaterThan(8);
            }
        }
        // Her own skin: about as much body, for the same neck and abdomen.
        TriangleMesh own = skin(body(PatientStructure.Source.SCAN));
        double ratio = MeshMeasure.signedVolume(skin) / MeshMeasure.signedVolume(own);
        assertThat(ratio).isCloseTo(1, within(0.25));
    }

    /**
     * In a scan of the whole body the arms lie beside the trunk, 60 mm from the ribs: a needle does not enter there.
     */
    @Test
    void anArmBesideTheTrunkIsOutsideTheSkinButForTheHeadOfItsBone() {
        List<Structure> trunk = body(PatientStructure.Source.VIRTUAL).structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() != StructureKind.SKIN)
                .toList();
        double[] ribs = PatientBody.bounds(trunk.stream().filter(s -> s.kind() == StructureKind.RIB))
                .orElseThrow();
        double x = ribs[0] - 60;
        double y = 0.5 * (ribs[1] + ribs[4]);
        TriangleMesh shoulderBlade = Shapes.moved(Shapes.sphere(15, 3), ribs[0] - 20, y, ribs[5] - 40);
        TriangleMesh shaft = Shapes.moved(Shapes.tube(12, 300, 24, 60), x, y, ribs[5] - 320);
        List<Structure> withArm = new ArrayList<>(trunk);
        withArm.add(new Structure("scapula_R", StructureKind.BONE, 0, Side.RIGHT, shoulderBlade));
        TriangleMesh skin = SkinEnvelope.around(withArm);
        withArm.add(new Structure("humerus_R", StructureKind.BONE, 0, Side.RIGHT, shaft));
        withArm.add(new Structure("other_radius_right", StructureKind.OTHER, 0, Side.MIDLINE, shaft));
        withArm.add(new Structure("other_right_ulna", StructureKind.OTHER, 0, Side.MIDLINE, shaft));
        withArm.add(new Structure("bone_skeleton", StructureKind.BONE, 0, Side.MIDLINE, shaft));
        withArm.add(new Structure("muscle_skeletal", StructureKind.MUSCLE, 0, Side.MIDLINE, shaft));
        SurfaceDistance distance = new SurfaceDistance(SkinEnvelope.around(withArm));
        double top = shaft.bounds()[5];
        assertThat(distance.signedDistance(new double[] {x, y, top - 5})[0])
                .as("head of the humerus, mm")
                .isLessThan(-10);
        double[] below = {x, y, top - 150, x, y, top - 250};
        assertThat(Arrays.stream(distance.signedDistance(below)))
                .as("shaft of the humerus, mm")
                .allMatch(d -> d > 20);
        double[] flank = {ribs[0], y, ribs[2] + 60};
        assertThat(distance.signedDistance(flank)[0])
                .as("the flank beside the arm, mm")
                .isCloseTo(new SurfaceDistance(skin).signedDistance(flank)[0], within(0.5));
    }

    /**
     * A wall of the belly up to 60 mm before the costal margin, far from bones and organs where bowel and skin have no
     * labels, and an arm that lies before it.
     */
    @Test
    void theWallOfTheBellyIsInsideTheSkinUnderTheLabelOfAllMuscles() {
        List<Structure> trunk = body(PatientStructure.Source.VIRTUAL).structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() != StructureKind.SKIN && !OrganNames.isBowel(s.name()))
                .toList();
        double[] b = PatientBody.bounds(trunk.stream().filter(s -> s.kind() == StructureKind.RIB))
                .orElseThrow();
        double middle = b[2] - 20;
        double x = 0.5 * (b[0] + b[3]);
        double y = 0.5 * (b[1] + b[4]);
        TriangleMesh arm = Shapes.moved(stretched(b[3] - b[0], 20, 20), x, b[1] - 140, middle);
        for (double before : new double[] {10, 60}) {
            TriangleMesh belly =
                    Shapes.moved(stretched(0.45 * (b[3] - b[0]), 0.5 * (b[4] - b[1]) + before, 100), x, y, middle);
            TriangleMesh skin = skinAroundMuscle(trunk, belly);
            assertThat(Arrays.stream(new SurfaceDistance(skin).signedDistance(belly.positions())))
                    .as("%s mm before the margin", before)
                    .allMatch(distance -> distance < -8);
            assertThat(skinAroundMuscle(trunk, MeshMerge.merge(List.of(belly, arm)))
                            .positions())
                    .isEqualTo(skin.positions());
        }
    }

    /** A sphere with these half axes. */
    private static TriangleMesh stretched(double a, double b, double c) {
        TriangleMesh sphere = Shapes.sphere(1, 4);
        double[] axes = {a, b, c};
        double[] p = sphere.positions().clone();
        Arrays.setAll(p, i -> p[i] * axes[i % 3]);
        return sphere.withPositions(p);
    }

    private static TriangleMesh skinAroundMuscle(List<Structure> trunk, TriangleMesh muscle) {
        List<Structure> all = new ArrayList<>(trunk);
        all.add(new Structure("muscle_skeletal", StructureKind.MUSCLE, 0, Side.MIDLINE, muscle));
        return SkinEnvelope.around(all);
    }

    /** A couch 25 mm behind the trunk, and a target volume that reaches 60 mm out of it. */
    @Test
    void aCouchAndATargetVolumeDoNotWidenTheSkin() {
        List<Structure> trunk = body(PatientStructure.Source.VIRTUAL).structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() != StructureKind.SKIN)
                .toList();
        double[] b = PatientBody.bounds(trunk.stream()).orElseThrow();
        double[] skin = SkinEnvelope.around(trunk).bounds();
        double z = 0.5 * (b[2] + b[5]);
        List<Structure> all = new ArrayList<>(trunk);
        all.add(new Structure(
                "other_CouchSurface",
                StructureKind.OTHER,
                0,
                Side.MIDLINE,
                Shapes.moved(Shapes.sphere(60, 3), 0, b[4] + 85, z)));
        all.add(new Structure(
                "lesion_ptv",
                StructureKind.LESION,
                0,
                Side.MIDLINE,
                Shapes.moved(Shapes.sphere(40, 3), b[0] - 20, 0.5 * (b[1] + b[4]), z)));
        assertThat(SkinEnvelope.around(all).bounds()).containsExactly(skin);
    }

    private static double[] lowerEnd(List<Structure> body) {
        double[] skin = SkinEnvelope.around(body).bounds();
        double[] margin = PatientBody.bounds(
                        body.stream().filter(s -> s.kind() == StructureKind.RIB && s.level() >= 7 && s.level() <= 10))
                .orElseThrow();
        return new double[] {skin[2], margin[2]};
    }

    /** A scan of the chest shows the flexure of the colon; its skin ends above the costal margin. */
    @Test
    void aSliverOfBowelOrASkinThatEndsInTheChestDoesNotFillTheAbdomen() {
        List<Structure> bones = body(PatientStructure.Source.VIRTUAL).structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA)
                .filter(s -> s.level() <= 12)
                .toList();
        double[] alone = lowerEnd(bones);
        assertThat(alone[0]).as("abdomen below the margin").isLessThan(alone[1] - 80);
        TriangleMesh flexure = Shapes.moved(Shapes.sphere(20, 3), 90, 0, alone[1] + 30);
        TriangleMesh chest = Shapes.moved(Shapes.sphere(60, 3), 0, 0, alone[1] + 150);
        for (Structure part : List.of(
                new Structure("colon", StructureKind.ORGAN, 0, Side.MIDLINE, flexure),
                new Structure("skin", StructureKind.SKIN, 0, Side.MIDLINE, chest))) {
            List<Structure> shown = new ArrayList<>(bones);
            shown.add(part);
            assertThat(lowerEnd(shown)[0]).as(part.name()).isCloseTo(alone[0], within(1.0));
        }
        for (String name : List.of("colon", "organ_bowel")) {
            List<Structure> shown = new ArrayList<>(bones);
            TriangleMesh bowel = Shapes.moved(Shapes.sphere(60, 3), 0, -50, alone[1] - 10);
            shown.add(new Structure(name, StructureKind.ORGAN, 0, Side.MIDLINE, bowel));
            assertThat(lowerEnd(shown)[0]).as(name + " that fills it").isGreaterThan(alone[0] + 20);
        }
    }

    /** Of a large body of bones alone, twice as wide as usual: the abdomen is full from the costal margin down. */
    @Test
    void theTrunkBelowTheCageIsNotHollow() {
        List<Structure> bones = body(PatientStructure.Source.VIRTUAL).structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA)
                .map(s -> s.withMesh(s.mesh()
                        .withPositions(Arrays.stream(s.mesh().positions())
                                .map(x -> 1.5 * x)
                                .toArray())))
                .toList();
        TriangleMesh skin = SkinEnvelope.around(bones);
        assertThat(new MeshTopology(skin).eulerCharacteristic()).isEqualTo(2);
        double[] spine = PatientBody.merged(
                        bones.stream().filter(s -> s.kind() == StructureKind.VERTEBRA && s.level() == 12))
                .orElseThrow()
                .bounds();
        double lowest = skin.bounds()[2];
        double[] inside = new double[3 * 4];
        for (int i = 0; i < 4; i++) {
            inside[3 * i] = 0.5 * (spine[0] + spine[3]);
            inside[3 * i + 1] = spine[1] - 60;
            inside[3 * i + 2] = lowest + 30 + i * (spine[2] - lowest - 30) / 4;
        }
        assertThat(Arrays.stream(new SurfaceDistance(skin).signedDistance(inside)))
                .allMatch(distance -> distance < -10);
    }

    @Test
    void theSkinOfAScanStaysUnlessItEndsBelowTheRibs() {
        PatientBody whole = body(PatientStructure.Source.SCAN);
        assertThat(SkinEnvelope.complete(whole)).isSameAs(whole);
        TriangleMesh own = skin(whole);
        double cut = own.bounds()[2] + 0.5 * (own.bounds()[5] - own.bounds()[2]);
        double[] p = own.positions().clone();
        for (int z = 2; z < p.length; z += 3) {
            p[z] = Math.min(p[z], cut);
        }
        List<PatientStructure> abdomen = whole.structures().stream()
                .map(s -> s.structure().kind() == StructureKind.SKIN
                        ? s.withStructure(s.structure().withMesh(own.withPositions(p)))
                        : s)
                .toList();
        TriangleMesh grown = skin(SkinEnvelope.complete(new PatientBody("body", abdomen, List.of(), List.of())));
        assertThat(grown.bounds()[5]).isGreaterThan(own.bounds()[5] - 60);
        double waist = own.bounds()[3] - own.bounds()[0];
        assertThat(grown.bounds()[3] - grown.bounds()[0]).isCloseTo(waist, within(0.15 * waist));
    }

    /** A field of view that ends 20 mm within the ribs of the right side; the ribs themselves are completed. */
    @Test
    void theSkinOfANarrowFieldOfViewIsGrownAroundTheRibsOutsideIt() {
        PatientBody whole = body(PatientStructure.Source.SCAN);
        TriangleMesh own = skin(whole);
        double[] ribs = PatientBody.bounds(whole.structures().stream()
                        .map(PatientStructure::structure)
                        .filter(s -> s.kind() == StructureKind.RIB))
                .orElseThrow();
        double[] p = own.positions().clone();
        for (int x = 0; x < p.length; x += 3) {
            p[x] = Math.max(p[x], ribs[0] + 20);
        }
        List<PatientStructure> narrow = whole.structures().stream()
                .map(s -> s.structure().kind() == StructureKind.SKIN
                        ? s.withStructure(s.structure().withMesh(own.withPositions(p)))
                        : s)
                .toList();
        PatientBody grown = SkinEnvelope.complete(new PatientBody("body", narrow, List.of(), List.of()));
        SurfaceDistance distance = new SurfaceDistance(skin(grown));
        for (Structure s : grown.thorax().structuresOf(StructureKind.RIB)) {
            assertThat(Arrays.stream(distance.signedDistance(s.mesh().positions())))
                    .as(s.name())
                    .allMatch(d -> d < -8);
        }
        assertThat(skin(grown).bounds()[3]).isCloseTo(own.bounds()[3], within(10.0));
        assertThat(grown.notes())
                .containsExactly(
                        "the skin is a smooth envelope of bones and organs, 15 mm outside them, and of the skin"
                                + " that the scan shows");
    }
}
