package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;

/** Ribs, sternum and what they carry, on the virtual adult male. */
class LinearBlendSkinningTest {
    private static final double EXACT_MM = 1e-9;

    /**
     * Neighbours of the insertion at full inspiration, where the margin moves 20 to 40 mm; a sixth of it in a quiet
     * breath.
     */
    private static final double NEIGHBOURS_MM = 8;

    private static Thorax male;
    private static RibCage cage;
    private static SkinningWeights bones;

    @BeforeAll
    static void make() throws IOException {
        male = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        cage = RibCage.of(male, RibAxisTable.preset(RibAxisTable.WILSON_CT), true);
        bones = SkinningWeights.of(male, cage);
    }

    /** Amplitude 0.5 (1 - cos t) and its rate. */
    private static RibCagePose breathing() {
        return new RibCagePose(cage, (t, out) -> {
            out[0] = 0.5 * (1 - Math.cos(t));
            out[1] = 0.5 * Math.sin(t);
        });
    }

    private static double[] at(LinearBlendSkinning motion, double time) {
        double[] x = new double[3 * motion.pointCount()];
        motion.at(time, x, new double[x.length]);
        return x;
    }

    @Test
    void theCageHasAllRibsTheSternumAndATrunkThatStays() {
        assertThat(cage.bodies()).hasSize(26);
        assertThat(cage.sternum()).isEqualTo(25);
        assertThat(cage.rib(5, Side.RIGHT)).isPositive();
        assertThat(cage.rib(13, Side.RIGHT)).isEqualTo(-1);
        RibCagePose pose = breathing();
        pose.update(Math.PI);
        assertThat(pose.amplitude()).isCloseTo(1, within(1e-12));
        assertThat(pose.pose(RibCage.TRUNK))
                .containsExactly(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, within(0.0));
    }

    @Test
    void thePoseOfARibIsThatOfItsHelicalAxis() {
        RibCagePose pose = breathing();
        pose.update(Math.PI);
        int rib = cage.rib(6, Side.LEFT);
        double[] moved = new double[3];
        HelicalBody.transformPoints(pose.pose(rib), new double[] {100, -50, 20}, 0, moved, 0, 1);
        assertThat(moved)
                .containsExactly(
                        cage.bodies().get(rib).axis().orElseThrow().motion().apply(100, -50, 20), within(EXACT_MM));
    }

    @Test
    void aPointOnOneBoneAloneGoesExactlyWithIt() {
        Structure rib = male.find("rib_03_R").orElseThrow();
        double[] p = IntStream.range(0, rib.mesh().vertexCount())
                .filter(i -> rib.mesh().x(i) < -80)
                .limit(50)
                .boxed()
                .flatMapToDouble(i -> java.util.stream.DoubleStream.of(
                        rib.mesh().x(i), rib.mesh().y(i), rib.mesh().z(i)))
                .toArray();
        int body = cage.rib(3, Side.RIGHT);
        SkinningWeights.Weights one = new SkinningWeights.Weights(
                IntStream.range(0, p.length / 3 * SkinningWeights.MAX_BODIES)
                        .map(i -> body)
                        .toArray(),
                IntStream.range(0, p.length / 3 * SkinningWeights.MAX_BODIES)
                        .mapToDouble(i -> i % SkinningWeights.MAX_BODIES == 0 ? 1 : 0)
                        .toArray(),
                new double[p.length / 3]);
        RibCagePose pose = breathing();
        double[] blended = at(new LinearBlendSkinning(pose, p, one, Workers.of(1)), 2);
        double[] rigid = new double[p.length];
        HelicalBody.transformPoints(pose.pose(body), p, 0, rigid, 0, p.length / 3);
        assertThat(blended).containsExactly(rigid, within(EXACT_MM));
    }

    @Test
    void atRestPointsAreWhereTheyWere() {
        double[] rim = rim();
        assertThat(at(new LinearBlendSkinning(breathing(), rim, bones.weightsAt(rim), Workers.of(1)), 0))
                .containsExactly(rim, within(EXACT_MM));
    }

    @Test
    void withoutASternumTheFirstCostalCartilageGoesWithItsRib() {
        Thorax bare = new Thorax(
                male.name(),
                male.structures().stream()
                        .filter(s -> s.kind() != StructureKind.STERNUM)
                        .toList(),
                male.notes());
        RibCage ribs = RibCage.of(bare, RibAxisTable.preset(RibAxisTable.WILSON_CT), true);
        BoneSamples samples = BoneSamples.of(bare, ribs);
        for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
            TriangleMesh cartilage = bare.find(StructureKind.COSTAL_CARTILAGE, 1, side)
                    .orElseThrow()
                    .mesh();
            double[] first = {cartilage.x(0), cartilage.y(0), cartilage.z(0)};
            int at = IntStream.range(0, samples.points.size())
                    .filter(i -> Arrays.equals(samples.points.get(i), first))
                    .findFirst()
                    .orElseThrow();
            assertThat(samples.weights.get(at)[ribs.rib(1, side)]).isEqualTo(1);
        }
        samples.weights.forEach(w -> assertThat(Arrays.stream(w).sum()).isCloseTo(1, within(1e-12)));
    }

    @Test
    void weightsArePositiveAndSumToOne() {
        SkinningWeights.Weights blend = bones.weightsAt(rim());
        for (int i = 0; i < blend.distance().length; i++) {
            double sum = 0;
            for (int k = 0; k < SkinningWeights.MAX_BODIES; k++) {
                double w = blend.weight()[i * SkinningWeights.MAX_BODIES + k];
                assertThat(w).isNotNegative();
                sum += w;
            }
            assertThat(sum).isCloseTo(1, within(1e-12));
        }
    }

    @Test
    void aRibsOwnVerticesAreCarriedByIt() {
        for (int level : new int[] {2, 5, 8}) {
            Structure rib = male.find("rib_0" + level + "_L").orElseThrow();
            SkinningWeights.Weights blend = bones.weightsAt(rib.mesh().positions());
            int body = cage.rib(level, Side.LEFT);
            int own = 0;
            for (int i = 0; i < blend.distance().length; i++) {
                own += blend.body()[i * SkinningWeights.MAX_BODIES] == body ? 1 : 0;
            }
            // Its head lies against the vertebra, its end against the cartilage.
            assertThat(own).as("rib " + level).isGreaterThan((int) (0.8 * blend.distance().length));
        }
    }

    @Test
    void velocityIsTheRateOfChangeOfPosition() {
        double[] rim = rim();
        LinearBlendSkinning motion = new LinearBlendSkinning(breathing(), rim, bones.weightsAt(rim), Workers.of(1));
        double h = 1e-4;
        for (double time : new double[] {0.3, 1.7, 4}) {
            double[] v = new double[rim.length];
            motion.at(time, new double[rim.length], v);
            double[] after = at(motion, time + h);
            double[] before = at(motion, time - h);
            for (int i = 0; i < rim.length; i++) {
                assertThat(v[i]).isCloseTo((after[i] - before[i]) / (2 * h), within(1e-4));
            }
        }
    }

    /** Neighbours along the insertion (7 mm apart) must not be torn apart, or the sheet's border would be in folds. */
    @Test
    void theCostalMarginMovesAsOneSmoothBand() {
        Diaphragm d =
                Diaphragm.withTrefoilTendon(male.find("diaphragm").orElseThrow().mesh());
        double[] p = d.sheet().positions();
        LinearBlendSkinning motion = new LinearBlendSkinning(breathing(), p, bones.weightsAt(p), Workers.of(1));
        double[] full = at(motion, Math.PI);
        int[] edges = d.topology().edges();
        double farthest = 0;
        double largest = 0;
        for (int e = 0; e < edges.length; e += 2) {
            int a = edges[e];
            int b = edges[e + 1];
            if (!d.isInserted(a) || !d.isInserted(b)) {
                continue;
            }
            double squared = 0;
            double moved = 0;
            for (int axis = 0; axis < 3; axis++) {
                int i = 3 * a + axis;
                int j = 3 * b + axis;
                squared += Math.pow(full[i] - p[i] - full[j] + p[j], 2);
                moved += Math.pow(full[i] - p[i], 2);
            }
            farthest = Math.max(farthest, Math.sqrt(squared));
            largest = Math.max(largest, Math.sqrt(moved));
        }
        assertThat(largest).as("motion of the margin at full inspiration").isBetween(10.0, 50.0);
        assertThat(farthest).as("between neighbours").isLessThan(NEIGHBOURS_MM);
    }

    @Test
    void theSternumGoesUpAndForwardAtFullInspiration() {
        double[] p = {0, -100, 200};
        RibCagePose pose = breathing();
        pose.update(Math.PI);
        double[] moved = new double[3];
        HelicalBody.transformPoints(pose.pose(cage.sternum()), p, 0, moved, 0, 1);
        // Physiology A4: cranial 20 to 35 mm, ventral 10 to 25 mm, sideways nothing.
        assertThat(moved[2] - p[2]).isBetween(15.0, 40.0);
        assertThat(p[1] - moved[1]).isBetween(5.0, 30.0);
        assertThat(moved[0]).isCloseTo(0, within(1.0));
    }

    private static double[] rim() {
        Diaphragm d =
                Diaphragm.withTrefoilTendon(male.find("diaphragm").orElseThrow().mesh());
        return IntStream.range(0, d.sheet().vertexCount())
                .filter(d::isInserted)
                .boxed()
                .flatMapToDouble(i -> java.util.stream.DoubleStream.of(
                        d.sheet().x(i), d.sheet().y(i), d.sheet().z(i)))
                .toArray();
    }
}
