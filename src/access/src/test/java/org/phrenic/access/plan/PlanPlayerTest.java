package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.path.AccessMap;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Frame;

/** Plans played on a body of boxes that breathes once in four seconds: 1.6 s in, 1.8 s out, 0.6 s at rest. */
class PlanPlayerTest {
    private static final double FRAME_S = 0.02;

    @TempDir
    Path folder;

    private final BoxAnatomy body = new BoxAnatomy();
    private final List<Boolean> held = new ArrayList<>();
    private NeedleSnapshots snapshots = new NeedleSnapshots();
    private double stoppedFromS;
    private double stoppedToS;

    private RespiratoryPhase label(double timeS) {
        double at = timeS % 4;
        if (timeS > stoppedFromS && timeS < stoppedToS) {
            return RespiratoryPhase.HOLD;
        }
        return at < 1.6
                ? RespiratoryPhase.INSPIRATION
                : at < 3.4 ? RespiratoryPhase.EXPIRATION : RespiratoryPhase.PAUSE;
    }

    /** Plays a plan's steps and returns the session at its end. */
    private NeedleInsertion play(String steps) throws IOException {
        Path file = Files.writeString(
                folder.resolve("plan.yaml"),
                "target: {rest_mm: [90, 0, 0], diameter_mm: 20}\ngive_up_after_s: 20\nneedle: {length_mm: 100}\n"
                        + steps);
        RehearsalPlan plan = RehearsalPlan.read(file);
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        TargetLesion target = plan.target(scene);
        NeedleInsertion needle = new NeedleInsertion(scene, target, plan.needle(), plan.avoided());
        try (Workers workers = Workers.of(1)) {
            AccessMap map = AccessMap.of(
                    scene,
                    List.of(new BreathMoment(body.still(0), RespiratoryPhase.PAUSE, 4)),
                    target,
                    plan.needle(),
                    plan.avoided(),
                    workers);
            snapshots = new NeedleSnapshots();
            PlanPlayer player =
                    new PlanPlayer(plan, needle, snapshots, new HeldProbe(scene), map, (on, origin) -> held.add(on));
            for (int i = 0; ; i++) {
                double t = i * FRAME_S;
                Frame frame = body.frame(t, t / 4 % 1, new double[3], -100, 0);
                needle.update(frame, label(t));
                if (player.update(frame, label(t), 1 + (int) (t / 4 + 1e-9))) {
                    return needle;
                }
            }
        }
    }

    @Test
    void aTriggerFiresAtItsPhaseOfItsBreath() throws IOException {
        NeedleInsertion needle = play("steps: [{wait: end-expiration of breath 3}, {place: {entry: [0, 0, 0]}}]");
        assertThat(needle.timeS()).isBetween(11.4 - 1e-9, 11.4 + FRAME_S + 1e-9);
        needle = play("steps: [{wait: end-inspiration of breath 2}, {place: {entry: [0, 0, 0]}}]");
        assertThat(needle.timeS()).isBetween(5.6 - 1e-9, 5.6 + FRAME_S + 1e-9);
        needle = play("steps: [{wait: inspiration of breath 2}, {wait: 0.5}, {place: {entry: [0, 0, 0]}}]");
        assertThat(needle.timeS()).isBetween(4.5 - 1e-9, 4.5 + FRAME_S + 1e-9);
    }

    /** A wait without a number is for the next event, which is not the one that ended the wait before. */
    @Test
    void twoWaitsAreForTwoBreaths() throws IOException {
        String twice = "steps: [{wait: %1$s}, {image: {}}, {wait: %1$s}, {place: {entry: [0, 0, 0]}}]";
        assertThat(play(String.format(Locale.ROOT, twice, "end-inspiration")).timeS())
                .isBetween(5.6 - 1e-9, 5.6 + FRAME_S + 1e-9);
        assertThat(play(String.format(Locale.ROOT, twice, "end-expiration")).timeS())
                .isBetween(7.4 - 1e-9, 7.4 + FRAME_S + 1e-9);
    }

    /** The breath is held 1 s after an inspiration or expiration began, and soon goes on. */
    @ParameterizedTest
    @CsvSource({"inspiration, 5.0, end-inspiration, 5.6", "end-inspiration, 6.6, end-expiration, 7.4"})
    void aHoldInMidBreathIsNoEndOfIt(String before, double holdS, String end, double expectedS) throws IOException {
        stoppedFromS = holdS + 0.05;
        stoppedToS = holdS + 0.25;
        String held = "  - wait: " + before + " of breath 2\n  - wait: 1\n  - hold_breath: true\n";
        String wait = "  - wait: " + end + "\n  - place: {entry: [0, 0, 0]}\n";
        double inHoldS = play("steps:\n" + held + "  - wait: hold\n  - wait: 0.06\n  - hold_breath: false\n" + wait)
                .timeS();
        assertThat(inHoldS).isBetween(expectedS - 1e-9, expectedS + FRAME_S + 1e-9);
        double asHeldS = play("steps:\n" + held + wait).timeS();
        assertThat(asHeldS).isBetween(expectedS - 1e-9, expectedS + FRAME_S + 1e-9);
    }

    /** No step holds the breath, so the pattern does: as in a hold at full inspiration, or before a cough. */
    @Test
    void aHoldOfThePatternBeginsAtTheEndOfTheInspiration() throws IOException {
        stoppedFromS = 5.59;
        stoppedToS = 7;
        NeedleInsertion needle = play("steps: [{wait: end-inspiration of breath 2}, {place: {entry: [0, 0, 0]}}]");
        assertThat(needle.timeS()).isBetween(5.6 - 1e-9, 5.6 + FRAME_S + 1e-9);
    }

    /** A breath that goes on from a hold has not begun there. */
    @Test
    void goingOnInMidInspirationIsNoInspiration() throws IOException {
        stoppedFromS = 5.03;
        stoppedToS = 5.2;
        NeedleInsertion needle = play("steps: [{wait: 5}, {hold_breath: true}, {wait: hold}, {hold_breath: false},"
                + " {wait: inspiration}, {place: {entry: [0, 0, 0]}}]");
        assertThat(needle.timeS()).isBetween(8 - 1e-9, 8 + FRAME_S + 1e-9);
    }

    @Test
    void stepsAreDoneInOrderEachWhenTheLastIsDone() throws IOException {
        NeedleInsertion needle = play("steps:\n  - hold_breath: true\n  - place: {entry: [0, 0, 0], aim: target}\n"
                + "  - advance: {speed_mm_per_s: 45}\n  - sample: now\n  - withdraw: {speed_mm_per_s: 90}\n"
                + "  - hold_breath: false\n");
        assertThat(held).containsExactly(true, false);
        assertThat(needle.shaft().isPlaced()).isFalse();
        assertThat(needle.record().hit()).isTrue();
        // 90 mm in at 45 mm/s, out at 90 mm/s.
        assertThat(needle.timeS()).isBetween(3.0 - FRAME_S, 3.0 + 3 * FRAME_S);
    }

    /** All steps but the advance are done in one frame: the pictures show the needle before what follows them. */
    @Test
    void aPictureShowsTheNeedleAsItIsAtItsStepWhateverFollowsInTheSameFrame() throws IOException {
        play("steps:\n  - image: {}\n  - place: {entry: [0, 0, 0], aim: [90, 0, 0]}\n"
                + "  - redirect: {aim: [90, 0, 20]}\n  - advance: {depth_mm: 20, speed_mm_per_s: 900}\n"
                + "  - image: {}\n  - sample: now\n  - redirect: {aim: [90, 0, 0]}\n  - sample: now\n"
                + "  - place: {entry: [0, 5, 0], aim: target}\n  - image: {}\n");
        assertThat(snapshots.all())
                .extracting(NeedleSnapshot::name)
                .containsExactly(
                        "ultrasound_1", "placed", "ultrasound_2", "sample", "sample_2", "placed_2", "ultrasound_3");
        assertThat(snapshots.all())
                .extracting(NeedleSnapshot::placed)
                .containsExactly(false, true, true, true, true, true, true);
        double slantedMm = 20 * 20 / Math.hypot(90, 20);
        assertThat(tipZ(1)).as("put on the skin").isZero();
        assertThat(snapshots.all().get(1).hub()[2]).as("before it is turned").isCloseTo(0, within(1e-9));
        assertThat(tipZ(2)).isCloseTo(slantedMm, within(1e-9));
        assertThat(tipZ(3)).isCloseTo(slantedMm, within(1e-9));
        assertThat(tipZ(4)).as("turned").isCloseTo(0, within(1e-9));
        assertThat(snapshots.all().get(5).tip()[1]).as("at another place").isCloseTo(5, within(1e-9));
        assertThat(snapshots.all().get(6).tip()[1]).as("left there").isCloseTo(5, within(1e-9));
    }

    private double tipZ(int snapshot) {
        return snapshots.all().get(snapshot).tip()[2];
    }

    /** Out of the skin and in again in one frame. */
    @Test
    void eachPlacementHasItsPicture() throws IOException {
        play("steps:\n  - place: {entry: [0, 0, 0], aim: target}\n  - advance: {depth_mm: 20}\n  - withdraw: {}\n"
                + "  - place: {entry: [0, 5, 0], aim: target}\n");
        assertThat(snapshots.all()).extracting(NeedleSnapshot::name).containsExactly("placed", "placed_2");
        assertThat(snapshots.all().get(1).tip()[1]).isCloseTo(5, within(1e-9));
    }

    @Test
    void whatNeverComesIsSaidInASentence() {
        assertThatThrownBy(() -> play("steps: [{wait: hold}]"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("step 1, wait")
                .hasMessageContaining("there was no hold");
        assertThatThrownBy(() -> play("steps: [{wait: 9}, {wait: end-expiration of breath 2}]"))
                .hasMessageContaining("step 2, wait")
                .hasMessageContaining("over at");
    }

    @Test
    void aNeedleIsWithdrawnByNoStepThatWouldPushItDeeper() throws IOException {
        String in = "steps: [{place: {entry: [0, 0, 0], aim: target}}, {advance: {depth_mm: 15}}, ";
        assertThatThrownBy(() -> play(in + "{withdraw: {depth_mm: 20}}]"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("step 3, withdraw: depth_mm: found 20.0 mm with the tip at 15.0 mm");
        assertThat(play(in + "{withdraw: {depth_mm: 15}}]").shaft().depth()).isEqualTo(15);
        assertThat(play(in + "{withdraw: {depth_mm: 10}}]").shaft().depth()).isEqualTo(10);
        assertThat(play(in + "{advance: {depth_mm: 10}}, {advance: {depth_mm: 20}}]")
                        .shaft()
                        .depth())
                .as("a move goes both ways")
                .isEqualTo(20);
    }

    @Test
    void whatCannotBeDoneNamesItsStep() {
        assertThatThrownBy(() -> play("steps: [{advance: {depth_mm: 20}}]")).hasMessageContaining("step 1, advance");
        assertThatThrownBy(() -> play("steps: [{image: {skin: back}}]")).hasMessageContaining("right-intercostal");
        assertThatThrownBy(() -> play("steps: [{image: {depth_mm: 9}}]")).hasMessageContaining("40.0 to 300.0");
        assertThatThrownBy(() -> play("steps: [{place: {entry: [0, 0, 0], aim: [150, 0, 0]}}]"))
                .hasMessageContaining("step 1, place")
                .hasMessageContaining("longer needle");
        assertThatThrownBy(() -> play("steps: [{place: {entry: [0, 0, 0]}}, {sample: now}]"))
                .hasMessageContaining("step 2, sample");
    }
}
