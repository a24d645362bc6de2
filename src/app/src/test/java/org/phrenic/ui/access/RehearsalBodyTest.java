package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** A liver in a box of skin. */
class RehearsalBodyTest {
    /** A frame of the scene with its liver, the second surface, at rest. */
    static Frame frame(List<Surface> surfaces) {
        double[] liver = surfaces.get(1).rest().positions();
        int[] lengths = new int[surfaces.size()];
        lengths[1] = liver.length;
        Frame frame = new Frame(new Object(), lengths, new boolean[lengths.length], 0);
        for (int i = 0; i < liver.length; i++) {
            frame.positions(1)[i] = (float) liver[i];
        }
        return frame;
    }

    /** A body whose scan does not show the skin. */
    static RehearsalBody body(List<Surface> surfaces) {
        Thorax scanned = new Thorax("patient", List.of(), List.of(), Set.of("skin"));
        return RehearsalBody.of(
                new LiveScene(Scenario.defaults(), surfaces, List.of(), () -> frame(surfaces), 0, scanned, 1));
    }

    @Test
    void whatIsNotInTheScanIsKnown() {
        assertThat(body(RehearsalPreparationTest.surfaces()).surfaces().notInScan())
                .containsExactly("skin");
    }

    /** The plan that is saved records as many moments again, of a recording of several breaths too. */
    @Test
    void aPracticePlanHasTheMomentsOfABreathAsItsPhases() {
        List<Surface> surfaces = RehearsalPreparationTest.surfaces();
        List<BreathMoment> moments = IntStream.range(0, 6)
                .mapToObj(i -> new BreathMoment(frame(surfaces), RespiratoryPhase.PAUSE, 4))
                .toList();
        RehearsalBody.StudiedTarget studied = body(surfaces)
                .studyTarget(
                        new TargetLesion(new double[] {40, 100, 100}, 20),
                        new RehearsalBody.Recorded(moments, 3),
                        Optional.empty(),
                        Scenario.defaults());
        assertThat(studied.plan().moments()).isEqualTo(3);
        assertThat(studied.study().map().cycle()).hasSize(6);
    }
}
