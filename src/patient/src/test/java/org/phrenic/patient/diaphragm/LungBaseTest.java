package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.TriangleMesh;

class LungBaseTest {
    private static final List<Structure> LUNGS =
            VirtualThorax.ofPreset("adult-male", Resolution.LOW).structuresOf(StructureKind.LUNG);

    /** Right and left. */
    private static List<LungBase> bases(List<Structure> lungs) {
        return LungBase.of(new Thorax("lungs", lungs, List.of()));
    }

    /** What lies below a height is so many times as far below it. */
    private static Structure stretched(Structure lung, double height, double times) {
        double[] p = lung.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] = p[i] < height ? height + times * (p[i] - height) : p[i];
        }
        return lung.withMesh(lung.mesh().withPositions(p));
    }

    /** At end-expiration the base is level: its dome is its top. */
    @Test
    void theDomeOfALevelBaseIsItsTop() {
        assertThat(bases(LUNGS)).hasSize(2).allSatisfy(base -> assertThat(base.dome())
                .isCloseTo(base.top(), within(5.0)));
    }

    /** Lungs that reach twice as far down around their domes, as at inspiration, have the same domes. */
    @Test
    void theDomeDoesNotFollowTheLowerBorder() {
        for (int side = 0; side < 2; side++) {
            double dome = bases(LUNGS).get(side).dome();
            List<Structure> steep =
                    LUNGS.stream().map(s -> stretched(s, dome, 2)).toList();
            assertThat(bases(steep).get(side).dome()).isCloseTo(dome, within(3.0));
        }
    }

    /**
     * A surface of revolution with a cone of 50 degrees below, from 0 down to -72 mm, and a level rim around it: the
     * only level faces are those of the rim, a third of the base.
     */
    @Test
    void aRimThatIsLevelIsNotTheTopOfTheBase() {
        double[][] profile = {
            {0, 0}, {20, -24}, {40, -48}, {60, -72}, {68, -72}, {75, -72}, {75, 50}, {40, 120}, {0, 150}
        };
        LungBase base = bases(List.of(revolved(profile))).get(0);
        assertThat(base.top()).isBetween(-50.0, -15.0);
        assertThat(base.dome()).isEqualTo(base.top());
    }

    /** A right lung of the profile (radius, height) from the bottom to the top, mm. */
    private static Structure revolved(double[]... profile) {
        int around = 48;
        List<double[]> points = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (double[] ring : profile) {
            for (int i = 0; i < around; i++) {
                double angle = 2 * Math.PI * i / around;
                points.add(new double[] {ring[0] * Math.cos(angle) - 80, ring[0] * Math.sin(angle), ring[1]});
            }
        }
        for (int ring = 0; ring + 1 < profile.length; ring++) {
            for (int i = 0; i < around; i++) {
                int a = ring * around + i;
                int b = ring * around + (i + 1) % around;
                faces.add(new int[] {a, b, b + around});
                faces.add(new int[] {a, b + around, a + around});
            }
        }
        TriangleMesh mesh = new TriangleMesh(
                points.stream().flatMapToDouble(Arrays::stream).toArray(),
                faces.stream().flatMapToInt(Arrays::stream).toArray());
        return new Structure("lung_R", StructureKind.LUNG, 0, Side.RIGHT, mesh);
    }
}
