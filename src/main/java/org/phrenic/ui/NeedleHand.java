package org.phrenic.ui;

import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import org.phrenic.geometry.Vectors;
import org.phrenic.rehearsal.BreathEvent;
import org.phrenic.rehearsal.LiveRehearsal;
import org.phrenic.rehearsal.NeedleState;

/** What a hand does with the needle and asks of the breath, from keys, buttons, slider and wheel alike. Nothing happens while the needle may not be used. */
final class NeedleHand {
    private static final double MM_A_NOTCH = 2;
    private static final double USUAL_MM_PER_S = 50;

    private final Session session;
    private final RehearsalDoor door;
    private final SceneView view;
    private double goalMm;
    private double speedMmPerS = USUAL_MM_PER_S;

    NeedleHand(Session session, RehearsalDoor door, SceneView view) {
        this.session = session;
        this.door = door;
        this.view = view;
    }

    /** What is asked is done in simulated time, so that has to go on. */
    private void ask(Consumer<LiveRehearsal> what) {
        door.usable().ifPresent(needle -> {
            what.accept(needle);
            if (!session.live().isPlaying()) {
                session.live().play();
            }
        });
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. */
    void enterAt(double[] onSkinRest) {
        ask(needle -> needle.enterAt(onSkinRest));
    }

    /** Whether the needle can be moved: an entry is chosen. */
    boolean canMove() {
        return door.usable().isPresent() && door.way().entry().isPresent();
    }

    /** Moves the needle's tip to a depth; one that is not in the body is set on the skin first. */
    void moveTo(double depthMm) {
        if (door.usable().isPresent() && door.way().entry().isEmpty()) {
            session.say(Session.Message.Kind.NOTE, "Choose an entry first (E), or take the best path (B).");
        } else if (canMove()) {
            goalMm = Math.max(0, Math.min(door.plan().orElseThrow().needle().lengthMm(), depthMm));
            if (goalMm > 0 || door.state().filter(NeedleState::placed).isPresent()) {
                ask(needle -> needle.moveTo(goalMm, speedMmPerS));
            }
        }
    }

    /** Moves it by so much from where it is or is going to. */
    void moveBy(double mm) {
        NeedleState now = door.state().orElse(null);
        double from = now == null || !now.placed() ? 0 : now.moving() ? goalMm : now.depthMm();
        moveTo(from + mm);
    }

    /** The wheel was turned for the needle; says whether it could be moved. */
    boolean turned(MouseWheelEvent e) {
        if (canMove()) {
            moveBy(-MM_A_NOTCH * e.getPreciseWheelRotation());
        }
        return canMove();
    }

    /** Moves it as deep as the target lies. */
    void moveToTarget() {
        door.state().ifPresent(now -> moveTo(now.aimedMm()));
    }

    void setSpeedMmPerS(double speed) {
        speedMmPerS = speed;
    }

    /** Points the needle at where the target is now. */
    void aim() {
        ask(LiveRehearsal::aim);
    }

    /** Takes a sample. */
    void sample() {
        ask(LiveRehearsal::sample);
    }

    /** Holds the breath at its next end, or lets it go on. */
    void hold(Optional<BreathEvent.Kind> end) {
        ask(needle -> needle.holdAt(end));
    }

    /** Holds the breath when air has flowed out, or lets a held one go on. */
    void toggleHold() {
        boolean holds = session.scenario().hold()
                || door.state().filter(s -> !s.waitsFor().isEmpty()).isPresent();
        hold(holds ? Optional.empty() : Optional.of(BreathEvent.Kind.END_EXPIRATION));
    }

    /** Looks from the hub towards the tip. */
    void lookAlong() {
        door.state()
                .filter(NeedleState::hasNeedle)
                .ifPresent(now -> view.setCamera(
                        view.camera().along(Vectors.unit(Vectors.minus(now.tip(), now.hub())), now.target())));
    }
}
