package org.phrenic.ui.access;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.mesh.Vectors;

/**
 * The ultrasound probe in the hand: put on the skin, slid, tilted, rocked, rotated and lifted, and the controls of its
 * scanner. Used on the event dispatch thread.
 */
public final class ProbeController {
    /** A needle in the image plane enters this far beside the middle of the probe, mm. */
    private static final double BESIDE_MM = 42;
    /** Angle between a needle beside the probe and the central scan line, degrees. */
    private static final double IN_PLANE_DEG = 45;

    private static final String NO_PROBE = "Put the probe on the skin first (U).";

    private final RehearsalController rehearsal;
    private Optional<double[]> place = Optional.empty();
    private ProbePose.Angles angles = ProbePose.Angles.ZERO;
    private UltrasoundSettings settings = UltrasoundSettings.DEFAULT;

    ProbeController(RehearsalController rehearsal) {
        this.rehearsal = rehearsal;
    }

    /** How the probe is held; empty while it is not on the skin. */
    public Optional<ProbeHold> hold() {
        return place.map(point -> ProbeHold.at(point, angles, settings));
    }

    private void send() {
        rehearsal.needle().command(run -> run.holdProbe(hold()));
    }

    /** Takes the probe away when another body is loaded. */
    void forget() {
        place = Optional.empty();
    }

    /** Puts the probe on a place of the skin, given at end-expiration. */
    public void put(double[] onSkinRest) {
        if (rehearsal.stage() == RehearsalStage.READY) {
            boolean first = place.isEmpty();
            place = Optional.of(onSkinRest.clone());
            send();
            if (first) {
                rehearsal.fireState();
            }
        }
    }

    public void lift() {
        if (place.isPresent()) {
            place = Optional.empty();
            send();
            rehearsal.fireState();
        }
    }

    /**
     * Slides the probe over the skin.
     *
     * @param lateralMm in the image plane, toward the marker
     * @param elevationMm out of the image plane
     */
    public void slide(double lateralMm, double elevationMm) {
        if (!isOnSkin()) {
            return;
        }
        place.ifPresent(at -> {
            ProbePose pose = restPose(at, new ProbePose.Angles(angles.rotationDeg(), 0, 0));
            double[] to = Vectors.addScaled(at, pose.lateral(), lateralMm);
            put(body().skin().nearestPoint(Vectors.addScaled(to, pose.elevation(), elevationMm)));
        });
    }

    private ProbePose restPose(double[] at, ProbePose.Angles held) {
        return body().skin().at(at).pose(body().frame(), held);
    }

    private RehearsalBody body() {
        return rehearsal.body.orElseThrow();
    }

    /** Turns the probe by so many degrees: about the skin's normal, out of the image plane, in the image plane. */
    public void turn(double rotationDeg, double tiltDeg, double rockDeg) {
        if (!isOnSkin()) {
            return;
        }
        double rotation = angles.rotationDeg() + rotationDeg;
        angles = new ProbePose.Angles(
                rotation > 180 ? rotation - 360 : rotation <= -180 ? rotation + 360 : rotation,
                limited(angles.tiltDeg() + tiltDeg),
                limited(angles.rockDeg() + rockDeg));
        send();
    }

    /** Whether the probe can be moved; where it is still to be put on the skin, that is said. */
    private boolean isOnSkin() {
        if (place.isEmpty() && rehearsal.stage() == RehearsalStage.READY) {
            rehearsal.note(NO_PROBE);
        }
        return place.isPresent();
    }

    private static double limited(double deg) {
        return Math.max(-ProbeHold.MOST_TILT_DEG, Math.min(ProbeHold.MOST_TILT_DEG, deg));
    }

    public ProbePose.Angles angles() {
        return angles;
    }

    /** The scanner's depth, gain and time-gain compensation. */
    public UltrasoundSettings settings() {
        return settings;
    }

    public void changeSettings(UnaryOperator<UltrasoundSettings> change) {
        settings = change.apply(settings);
        if (place.isPresent()) {
            send();
        }
    }

    /** Sets the entry of the needle beside the probe, on the marker's side, and points it into the image plane. */
    public void enterBeside() {
        Optional<ProbeState> state = rehearsal.state().flatMap(NeedleState::probe);
        if (place.isEmpty() || state.isEmpty()) {
            rehearsal.note(NO_PROBE);
            return;
        }
        double[] at = place.get();
        ProbePose upright = restPose(at, new ProbePose.Angles(angles.rotationDeg(), 0, 0));
        double[] entry = body().skin().inImagePlane(restPose(at, angles), upright, at, BESIDE_MM);
        ProbePose now = state.get().pose();
        double in = StrictMath.toRadians(IN_PLANE_DEG);
        double[] direction = Vectors.addScaled(
                Vectors.addScaled(new double[3], now.axial(), StrictMath.cos(in)), now.lateral(), -StrictMath.sin(in));
        rehearsal.entrySelection().select(entry, Optional.of(NeedleAngles.of(direction)));
    }
}
