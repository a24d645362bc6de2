package org.phrenic.ui.access;

import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.LiveRehearsal;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.mesh.Vectors;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;

/**
 * What a hand does with the needle and asks of the breath, from keys, buttons, slider and wheel alike. Nothing happens
 * while the needle may not be used.
 */
public final class NeedleController {
    private static final double MM_PER_NOTCH = 2;
    private static final double DEFAULT_MM_PER_S = 50;

    private final Session session;
    private final RehearsalController rehearsal;
    private final SceneViewport view;
    private double commandedDepthMm;
    private double speedMmPerS = DEFAULT_MM_PER_S;

    NeedleController(Session session, RehearsalController rehearsal, SceneViewport view) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.view = view;
    }

    /** What is asked is done in simulated time, so that has to go on. */
    private void command(Consumer<LiveRehearsal> what) {
        rehearsal.usableNeedle().ifPresent(needle -> {
            what.accept(needle);
            if (!session.live().isPlaying()) {
                session.live().play();
            }
        });
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. */
    void setEntry(double[] onSkinRest) {
        command(needle -> needle.enterAt(onSkinRest));
    }

    /** Whether the needle can be moved: an entry is chosen. */
    boolean canMove() {
        return rehearsal.usableNeedle().isPresent()
                && rehearsal.entrySelection().entry().isPresent();
    }

    /** Moves the needle's tip to a depth; one that is not in the body is set on the skin first. */
    public void moveTo(double depthMm) {
        if (rehearsal.usableNeedle().isPresent()
                && rehearsal.entrySelection().entry().isEmpty()) {
            session.note("Choose an entry first (E), or take the best path (B).");
        } else if (canMove()) {
            commandedDepthMm =
                    Math.max(0, Math.min(rehearsal.plan().orElseThrow().needle().lengthMm(), depthMm));
            if (commandedDepthMm > 0
                    || rehearsal.state().filter(NeedleState::placed).isPresent()) {
                command(needle -> needle.moveTo(commandedDepthMm, speedMmPerS));
            }
        }
    }

    /** Moves it by so much from where it is or is going to. */
    public void moveBy(double mm) {
        NeedleState now = rehearsal.state().orElse(null);
        double from = now == null || !now.placed() ? 0 : now.moving() ? commandedDepthMm : now.depthMm();
        moveTo(from + mm);
    }

    /** The wheel was turned for the needle; says whether it could be moved. */
    public boolean wheelTurned(MouseWheelEvent e) {
        if (canMove()) {
            moveBy(-MM_PER_NOTCH * e.getPreciseWheelRotation());
        }
        return canMove();
    }

    /** Moves it as deep as the target lies. */
    public void moveToTarget() {
        rehearsal.state().ifPresent(now -> moveTo(now.aimedDepthMm()));
    }

    public void setSpeedMmPerS(double speed) {
        speedMmPerS = speed;
    }

    /** Points the needle at where the target is now. */
    public void aimAtTarget() {
        command(LiveRehearsal::aim);
    }

    /** Takes a sample. */
    public void takeSample() {
        command(LiveRehearsal::sample);
    }

    /** Holds the breath at its next end, or lets it go on. */
    public void hold(Optional<BreathEvent.Kind> end) {
        command(needle -> needle.holdAt(end));
    }

    /** Holds the breath when air has flowed out, or lets a held one go on. */
    public void toggleHold() {
        boolean holds = session.scenario().hold()
                || rehearsal.state().filter(s -> !s.pendingHold().isEmpty()).isPresent();
        hold(holds ? Optional.empty() : Optional.of(BreathEvent.Kind.END_EXPIRATION));
    }

    /** Looks from the hub towards the tip. */
    public void lookAlong() {
        rehearsal
                .state()
                .filter(NeedleState::hasNeedle)
                .ifPresent(now -> view.setCamera(view.camera()
                        .lookingAlong(Vectors.normalize(Vectors.subtract(now.tip(), now.hub())), now.target())));
    }
}
