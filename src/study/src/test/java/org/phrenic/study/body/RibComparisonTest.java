package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

class RibComparisonTest {
    private static final Thorax BODY = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    private static Optional<RibComparison> against(UnaryOperator<double[]> move) {
        return against(move, move);
    }

    private static Optional<RibComparison> against(UnaryOperator<double[]> right, UnaryOperator<double[]> left) {
        List<Structure> ribs = BODY.structuresOf(StructureKind.RIB).stream()
                .filter(rib -> rib.level() == 5)
                .map(rib -> rib.withMesh(rib.mesh()
                        .withPositions((rib.side() == Side.RIGHT ? right : left)
                                .apply(rib.mesh().positions().clone()))))
                .toList();
        return RibComparison.of(BODY, new Thorax("other", ribs, List.of()));
    }

    private static double[] shifted(double[] p) {
        for (int i = 0; i < p.length; i += 3) {
            p[i] += 3;
            p[i + 2] += 4;
        }
        return p;
    }

    private static double[] turned(double[] p) {
        double c = Math.cos(Math.toRadians(10));
        double s = Math.sin(Math.toRadians(10));
        for (int i = 0; i < p.length; i += 3) {
            double x = p[i];
            p[i] = c * x - s * p[i + 1];
            p[i + 1] = s * x + c * p[i + 1];
        }
        return p;
    }

    @Test
    void shiftedRibsAreOffByTheShiftAndTheirAxesByItsPartAcross() {
        RibComparison same = against(p -> p).orElseThrow();
        assertThat(same.headGreatestMm()).isZero();
        assertThat(same.neckGreatestDeg()).isLessThan(1e-5);
        RibComparison shifted = against(RibComparisonTest::shifted).orElseThrow();
        assertThat(shifted.ribs()).isEqualTo(2);
        assertThat(shifted.headMeanMm()).isCloseTo(5, within(1e-9));
        assertThat(shifted.axisGreatestMm()).isLessThan(5).isGreaterThan(2);
        assertThat(shifted.neckGreatestDeg()).isLessThan(1e-5);
    }

    @Test
    void ofOneRibThatMovesTheMeansAreHalfOfTheGreatest() {
        RibComparison shifted = against(RibComparisonTest::shifted, p -> p).orElseThrow();
        assertThat(shifted.headMeanMm()).isCloseTo(2.5, within(1e-9));
        assertThat(shifted.headGreatestMm()).isCloseTo(5, within(1e-9));
        assertThat(shifted.axisGreatestMm()).isGreaterThan(2);
        assertThat(shifted.axisMeanMm()).isCloseTo(shifted.axisGreatestMm() / 2, within(1e-9));
        RibComparison turned = against(RibComparisonTest::turned, p -> p).orElseThrow();
        assertThat(turned.neckGreatestDeg()).isBetween(8.0, 10.1);
        assertThat(turned.neckMeanDeg()).isCloseTo(turned.neckGreatestDeg() / 2, within(1e-5));
    }

    /** A turn of the whole cage by 10 degrees about the long axis turns a neck, nearly transverse, by 10 degrees. */
    @Test
    void necksTurnWithTheRibs() {
        RibComparison turned = against(RibComparisonTest::turned).orElseThrow();
        assertThat(turned.neckMeanDeg()).isBetween(8.0, 10.1);
    }

    @Test
    void bodyWithoutRibsHasNothingToCompare() {
        assertThat(RibComparison.of(BODY, new Thorax("other", List.of(), List.of())))
                .isEmpty();
    }
}
