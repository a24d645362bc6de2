package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** What a section shows. */
class BodySectionTest {
    private static final double[] ENTRY = {-40, -100, 30};
    private static final NeedleAngles OBLIQUE = new NeedleAngles(30, 25);
    private static final double BESIDE_MM = 10;

    /** A needle whose target is beside it, out of the plane that is shown. */
    private static NeedleState state() {
        double[] needle = OBLIQUE.direction();
        double[] level = Vectors.normalize(Vectors.cross(needle, new double[] {0, 0, 1}));
        double[] target =
                Vectors.addScaled(Vectors.addScaled(ENTRY, needle, 80), Vectors.cross(needle, level), BESIDE_MM);
        return new NeedleState(
                1,
                RespiratoryPhase.PAUSE,
                target,
                8,
                Optional.of(ENTRY),
                true,
                Vectors.addScaled(ENTRY, needle, -100),
                Vectors.addScaled(ENTRY, needle, 50),
                50,
                80,
                false,
                Optional.empty(),
                List.of(),
                5,
                "",
                List.of(),
                0,
                OBLIQUE,
                Optional.empty(),
                NeedleLoad.NONE);
    }

    @Test
    void theSectionAlongTheNeedleHoldsTheNeedleThoughItPointsBesideTheTarget() {
        NeedleState state = state();
        List<Surface> beads = List.of(Markers.ball("hub", state.hub(), 1), Markers.ball("tip", state.tip(), 1));
        BodySection section = BodySection.alongNeedle(beads, Frame.still(beads), state);
        assertThat(section.parts()).as("beads on the needle that are cut").hasSize(2);
        section.parts().forEach(bead -> assertThat(bead.outline().getBounds2D().getWidth())
                .as("mm across a bead of 2 mm")
                .isCloseTo(2, within(0.05)));
        assertThat(Math.abs(section.targetPlaneDistanceMm())).isCloseTo(BESIDE_MM, within(1e-9));
        assertThat(section.targetSectionRadiusMm()).isZero();
    }

    /** A plan may avoid any kind, so each is seen where the needle goes. */
    @Test
    void aSectionShowsEveryKindOfStructureOnce() {
        assertThat(BodySection.PAINTING_ORDER).containsExactlyInAnyOrder(StructureKind.values());
        assertThat(BodySection.PAINTING_ORDER)
                .as("the lung lies within its pleura")
                .containsSubsequence(StructureKind.PLEURA, StructureKind.LUNG);
    }
}
