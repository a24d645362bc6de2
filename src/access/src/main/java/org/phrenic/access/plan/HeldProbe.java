package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbeOnSkin;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** The ultrasound probe of an attempt: how it is held, where it is in each frame, and how it is used. */
public final class HeldProbe {
    private final List<Surface> surfaces;
    private final CurvilinearProbe probe = CurvilinearProbe.abdominal();
    private Optional<ScannedSkin> skin = Optional.empty();
    private Optional<ProbeHold> hold = Optional.empty();
    private Optional<ProbeOnSkin> site = Optional.empty();
    private Optional<ProbePose> pose = Optional.empty();
    private Frame frame;

    private double timeS;
    private double sinceS;
    private double heldS;
    private double insideS;
    private double unseenS;
    private double seenMmS;
    private double seenShareS;

    /** @param anatomy whose skin the probe is put on */
    public HeldProbe(MovingAnatomy anatomy) {
        surfaces = anatomy.structures().stream().map(MovingStructure::surface).toList();
    }

    /** Begins to measure anew; the probe stays where it is. */
    public void begin(double nowS) {
        timeS = nowS;
        sinceS = nowS;
        heldS = 0;
        insideS = 0;
        unseenS = 0;
        seenMmS = 0;
        seenShareS = 0;
    }

    /**
     * Puts the probe on the skin, moves it, or lifts it.
     *
     * @throws BadInputException if the place is not on the skin; the probe then stays where it is
     */
    public void hold(Optional<ProbeHold> other) {
        Optional<ProbeOnSkin> at = other.isPresent() && isSamePlace(other.get()) ? site : other.map(this::place);
        if (hold.isPresent()) {
            heldS += timeS - sinceS;
        }
        sinceS = timeS;
        hold = other;
        site = at;
        locate();
    }

    private boolean isSamePlace(ProbeHold other) {
        return hold.filter(h -> h.window().equals(other.window()) && h.pointRest() == other.pointRest())
                .isPresent();
    }

    private ProbeOnSkin place(ProbeHold at) {
        if (skin.isEmpty()) {
            skin = Optional.of(new ScannedSkin(surfaces));
        }
        return at.on(surfaces, skin.get());
    }

    private void locate() {
        pose = site.map(s -> s.pose(frame, hold.orElseThrow().angles()));
    }

    /** Moves the probe with the skin to a frame that the needle has been updated to. */
    public void update(Frame now, NeedleInsertion needle) {
        double elapsed = now.timeS() - timeS;
        timeS = now.timeS();
        frame = now;
        locate();
        double depth = needle.shaft().depth();
        if (needle.shaft().isPlaced() && depth > 0) {
            insideS += elapsed;
            unseenS += isTipSeen(needle) ? 0 : elapsed;
            double seen = needleInBeamMm(needle);
            seenMmS += seen * elapsed;
            seenShareS += seen / depth * elapsed;
        }
    }

    /** Whether the tip is in the beam. */
    public boolean isTipSeen(NeedleInsertion needle) {
        return pose.isPresent() && inBody(needle).isTipInBeam(probe, pose.get(), imageDepthMm());
    }

    /** Length of the needle below the skin that is in the beam, mm. */
    public double needleInBeamMm(NeedleInsertion needle) {
        return pose.isPresent() ? inBody(needle).lengthInBeamMm(probe, pose.get(), imageDepthMm()) : 0;
    }

    private double imageDepthMm() {
        return hold.orElseThrow().settings().depthMm();
    }

    private static SonatedNeedle inBody(NeedleInsertion needle) {
        return new SonatedNeedle(needle.shaft().entry(), needle.shaft().tip(), needle.needle());
    }

    /** What an image at this moment is made of; empty while the probe is not on the skin. */
    public Optional<ImageMoment> moment(NeedleInsertion needle) {
        Needle tube = needle.needle();
        return pose.map(p -> new ImageMoment(
                p,
                hold.orElseThrow().settings(),
                needle.shaft().isPlaced()
                        ? Optional.of(new SonatedNeedle(
                                needle.hubNow(), needle.shaft().tip(), tube))
                        : Optional.empty(),
                needle.targetNow()));
    }

    /** How it is held; empty while it is not on the skin. */
    public Optional<ProbeHold> hold() {
        return hold;
    }

    /** Where it is; empty while it is not on the skin. */
    public Optional<ProbePose> pose() {
        return pose;
    }

    /** How it has been used up to the current frame. */
    public ProbeUse use() {
        double total = heldS + (hold.isPresent() ? timeS - sinceS : 0);
        return total > 0
                ? new ProbeUse(
                        total, unseenS, insideS > 0 ? seenMmS / insideS : 0, insideS > 0 ? seenShareS / insideS : 0)
                : ProbeUse.NONE;
    }
}
