package org.phrenic.ui.access;

import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.live.LiveRehearsal;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.mesh.Vectors;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;

/**
 * Commands to the needle and the breath, from keys, buttons, slider and wheel. They are ignored while the needle is not
 * usable.
 */
public final class NeedleController {
    private static final double MM_PER_NOTCH = 2;
    private static final double MM_PER_NOTCH_WITH_SHIFT = 10;
    private static final double DEFAULT_MM_PER_S = 50;

    private final Session session;
    private final RehearsalController rehearsal;
    private final SceneViewport view;
    private double speedMmPerS = DEFAULT_MM_PER_S;

    NeedleController(Session session, RehearsalController rehearsal, SceneViewport view) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.view = view;
    }

    /**
     * Passes a command to the needle, and resumes the simulation, in whose time it is carried out. After a played plan
     * an attempt by hand begins with it, from the start of the run.
     */
    void command(Consumer<LiveRehearsal> what) {
        rehearsal.attempt.takeOver();
        rehearsal.usableNeedle().ifPresent(needle -> {
            what.accept(needle);
            resume();
        });
    }

    /** Whether the report of a sample waits for the needle to be out. */
    public boolean isSampleUnreported() {
        return rehearsal.attempt.isSampleUnreported();
    }

    /** Does what would end an attempt, unless its needle is in the body: then it says what to do first. */
    public void unlessInBody(String name, Runnable what) {
        if (rehearsal.isAttemptUnderWay()) {
            session.note(name + " would end this attempt: take the needle out first (O).");
        } else {
            what.run();
        }
    }

    /** Gives the keys of needle and probe to the view. */
    public void takeKeys() {
        view.requestFocusInWindow();
    }

    private void resume() {
        if (!session.live().isPlaying()) {
            session.returnToLive();
            session.live().play();
        }
    }

    /** Resumes the simulation of an attempt, of whose steps pictures are taken. */
    public void resumeForPictures() {
        rehearsal.attempt.rehearsal().ifPresent(needle -> resume());
    }

    void setEntry(EntrySelection.Entry entry) {
        command(needle -> needle.enterAt(entry.restMm(), entry.angles()));
    }

    /** Whether the needle can be moved: it is usable and an entry is chosen. */
    boolean canMove() {
        return rehearsal.usableNeedle().isPresent()
                && rehearsal.entrySelection().entry().isPresent();
    }

    /** Whether a move was asked for that the state does not show. */
    boolean awaitsMoves() {
        return rehearsal.usableNeedle().filter(needle -> !needle.showsMoves()).isPresent();
    }

    /** Moves the tip to a depth, mm; a needle outside of the body is placed on the skin first. */
    public void moveTo(double depthMm) {
        move(depthMm > 0, needle -> {
            double lengthMm = rehearsal.plan().orElseThrow().needle().lengthMm();
            needle.moveTo(Math.max(0, Math.min(lengthMm, depthMm)), speedMmPerS);
        });
    }

    /** @param insertsOne whether a needle outside of the body comes in by this */
    private void move(boolean insertsOne, Consumer<LiveRehearsal> how) {
        if (canMove()) {
            boolean placed = rehearsal.state().filter(NeedleState::placed).isPresent();
            if (!placed && insertsOne) {
                rehearsal.pictures().place();
            }
            if (insertsOne || placed || awaitsMoves()) {
                command(how);
            }
        } else {
            askForEntry();
        }
    }

    private void askForEntry() {
        if (rehearsal.usableNeedle().isPresent()) {
            session.note("Choose an entry first (E), or take the best one (B).");
        }
    }

    /** Moves the tip from its depth, or in the same direction from the depth that it moves to. */
    public void moveBy(double mm) {
        move(mm > 0, needle -> needle.moveBy(mm, speedMmPerS));
    }

    /** Moves the needle by the wheel, with Shift in larger steps; false if it cannot be moved. */
    public boolean wheelTurned(MouseWheelEvent e) {
        if (canMove()) {
            double perNotch = e.isShiftDown() ? MM_PER_NOTCH_WITH_SHIFT : MM_PER_NOTCH;
            moveBy(-perNotch * e.getPreciseWheelRotation());
        }
        return canMove();
    }

    /** Moves the tip, forward or back, to where the needle passes nearest to the target. */
    public void moveToTarget() {
        rehearsal.state().ifPresent(now -> move(true, needle -> needle.moveToTarget(speedMmPerS)));
    }

    public void setSpeedMmPerS(double speed) {
        speedMmPerS = speed;
    }

    /** Lets the program point the needle at the target; the report says so. */
    public void aimAtTarget() {
        if (canMove()) {
            command(LiveRehearsal::aim);
        } else {
            askForEntry();
        }
    }

    /** Turns the needle by hand: in the axial plane, and toward the head, degrees. */
    public void turnBy(double axialDeg, double cranialDeg) {
        rehearsal
                .state()
                .filter(NeedleState::hasNeedle)
                .ifPresentOrElse(
                        now -> command(needle -> needle.turnBy(axialDeg, cranialDeg)), this::askForEntryIfNone);
    }

    /** Turns the needle by hand to some angles. */
    void turnTo(NeedleAngles angles) {
        command(needle -> needle.turnTo(angles));
    }

    /** The state of an entry that was just chosen comes with the next step. */
    private void askForEntryIfNone() {
        if (!canMove()) {
            askForEntry();
        }
    }

    /** Takes a sample, or says what to do before one can be taken. */
    public void takeSample() {
        boolean inside = rehearsal
                .state()
                .filter(now -> now.placed() && now.depthMm() > 0)
                .isPresent();
        if (inside || awaitsMoves()) {
            command(LiveRehearsal::sample);
        } else if (canMove()) {
            session.note("Insert the needle first (I).");
        } else {
            askForEntry();
        }
    }

    /** Holds the breath at the next end of a phase; empty releases it. */
    public void hold(Optional<BreathEvent.Kind> end) {
        command(needle -> needle.holdAt(end));
    }

    /** The end of a phase at which the breath is held by hand, or will be; empty if it goes on or is held elsewhere. */
    public Optional<BreathEvent.Kind> heldAt() {
        return rehearsal.attempt.rehearsal().flatMap(LiveRehearsal::heldAt);
    }

    /** Whether the breath is held, or will be at the next end of a phase. */
    public boolean isBreathHeld() {
        return rehearsal.attempt.rehearsal().map(LiveRehearsal::isBreathHeld).orElseGet(() -> session.scenario()
                .hold());
    }

    /** Holds the breath at end-expiration, or releases it. */
    public void toggleHold() {
        hold(isBreathHeld() ? Optional.empty() : Optional.of(BreathEvent.Kind.END_EXPIRATION));
    }

    public void lookAlong() {
        rehearsal
                .state()
                .filter(NeedleState::hasNeedle)
                .ifPresentOrElse(
                        now -> {
                            double[] direction = Vectors.normalize(Vectors.subtract(now.tip(), now.hub()));
                            view.setCamera(view.camera().lookingAlong(direction, now.target()));
                        },
                        this::askForEntryIfNone);
    }
}
