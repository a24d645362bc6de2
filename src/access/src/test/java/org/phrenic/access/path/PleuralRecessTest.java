package org.phrenic.access.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;

/** Ways through the recess of the coarse virtual man, with the pleura of both sides, of the right one and of none. */
class PleuralRecessTest {
    private static final double[] RIGHT_LOBE = {-90, 0, 50};
    private static final double[] LEFT_LOBE = {10, -65, 60};
    private static final double[] RIGHT_SPACE = {-156, 0, 20};
    private static final double[] RIGHT_ABOVE = {-156, 0, 60};
    private static final double[] RIGHT_BELOW = {-86, -117, -20};
    private static final double[] RIGHT_CENTRAL = {-60, -20, 20};
    private static final double[] RIGHT_SUBCOSTAL = {-70, -115, -60};
    private static final double[] LEFT_SPACE = {130, -80, 20};

    private static final Set<NoGoZone> LUNG_AND_PLEURA = Set.of(NoGoZone.LUNG, NoGoZone.PLEURA);

    private static PathAnalyzer of(MovingAnatomy body) {
        return new PathAnalyzer(body, Needle.standard());
    }

    private static PathAnalyzer without(Set<Side> pleurae) {
        return of(CoarseBreath.with(s -> s.kind() != StructureKind.PLEURA || !pleurae.contains(s.side())));
    }

    private static boolean touchesPleura(PathAnalyzer body, double[] entry, double[] target) {
        boolean touches = (body.touched(entry, target) & NoGoZone.PLEURA.bit()) != 0;
        assertThat(body.analyze(entry, target).crossesPleura()).isEqualTo(touches);
        return touches;
    }

    /** From the wall, or from where the lung ends, to the diaphragm. */
    @Test
    void withoutAPleuraAWayIntoTheDiaphragmAboveTheReflectionCrossesTheRecess() {
        PathAnalyzer body = without(Set.of(Side.RIGHT, Side.LEFT));
        assertThat(touchesPleura(body, RIGHT_SPACE, RIGHT_LOBE)).isTrue();
        PathAnalysis way = body.analyze(RIGHT_SPACE, RIGHT_LOBE);
        Crossing recess = way.crossing(Crossing.RECESS).orElseThrow();
        assertThat(recess.toMm())
                .isEqualTo(way.crossing("diaphragm").orElseThrow().fromMm());
        assertThat(recess.lengthMm()).as("from the ribs on").isBetween(4.0, 7.0);
        PathAnalysis above = body.analyze(RIGHT_ABOVE, RIGHT_LOBE);
        Crossing behindLung = above.crossing(Crossing.RECESS).orElseThrow();
        assertThat(behindLung.fromMm())
                .isEqualTo(above.crossing("lung_R").orElseThrow().toMm());
        assertThat(behindLung.toMm())
                .isEqualTo(above.crossing("diaphragm").orElseThrow().fromMm());
        assertThat(body.margin(RIGHT_SPACE, RIGHT_LOBE, LUNG_AND_PLEURA).mm()).isZero();
        assertThat(body.margin(RIGHT_SPACE, RIGHT_LOBE, Set.of(NoGoZone.LUNG)).mm())
                .isPositive();
        assertThat(touchesPleura(body, RIGHT_SUBCOSTAL, RIGHT_LOBE)).isFalse();
        assertThat(body.margin(RIGHT_SUBCOSTAL, RIGHT_LOBE, LUNG_AND_PLEURA).mm())
                .isPositive();
    }

    /** A way below the surface of the pleura, into the diaphragm where it borders the recess by the rule. */
    @Test
    void onASideWithAPleuraTheRuleTellsNothing() {
        PathAnalyzer right = without(Set.of(Side.LEFT));
        PathAnalyzer none = without(Set.of(Side.RIGHT, Side.LEFT));
        assertThat(touchesPleura(none, RIGHT_BELOW, RIGHT_CENTRAL)).isTrue();
        assertThat(touchesPleura(right, RIGHT_BELOW, RIGHT_CENTRAL)).isFalse();
    }

    @Test
    void aPleuraOfOneSideTellsNothingOfTheOther() {
        PathAnalyzer whole = without(Set.of());
        PathAnalyzer right = without(Set.of(Side.LEFT));
        PathAnalyzer none = without(Set.of(Side.RIGHT, Side.LEFT));
        for (PathAnalyzer body : new PathAnalyzer[] {whole, right, none}) {
            assertThat(touchesPleura(body, RIGHT_SPACE, RIGHT_LOBE)).isTrue();
            assertThat(touchesPleura(body, LEFT_SPACE, LEFT_LOBE)).isTrue();
        }
        assertThat(right.analyze(RIGHT_SPACE, RIGHT_LOBE)
                        .crossing(Crossing.RECESS)
                        .orElseThrow())
                .as("where the surface is")
                .isEqualTo(whole.analyze(RIGHT_SPACE, RIGHT_LOBE)
                        .crossing(Crossing.RECESS)
                        .orElseThrow());
        assertThat(right.analyze(LEFT_SPACE, LEFT_LOBE)
                        .crossing(Crossing.RECESS)
                        .orElseThrow()
                        .lengthMm())
                .isCloseTo(
                        none.analyze(LEFT_SPACE, LEFT_LOBE)
                                .crossing(Crossing.RECESS)
                                .orElseThrow()
                                .lengthMm(),
                        within(1e-9));
    }
}
