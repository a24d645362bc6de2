package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.Approach;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/** Accumulates the events and measures of an attempt frame by frame. */
final class AttemptLog {
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");

    private final Set<NoGoZone> avoided;
    private double timeS = Double.NaN;
    private double frameS;
    private int breath = 1;
    private double phase;
    private double phaseBefore;
    private RespiratoryPhase label = RespiratoryPhase.PAUSE;

    private final List<AttemptEvent> events = new ArrayList<>();
    private final List<TargetingError> samples = new ArrayList<>();
    private final Set<String> entered = new LinkedHashSet<>();
    private final EnumMap<NoGoZone, Double> secondsIn = new EnumMap<>(NoGoZone.class);
    private final EnumSet<NoGoZone> touchedByCore = EnumSet.noneOf(NoGoZone.class);
    private final Map<String, Approach> closest = new TreeMap<>();
    private double inNoGoS;
    private double insideSinceS = Double.NaN;
    private double insideS;
    private double endS = Double.NaN;
    private double tipTravelMm;
    private double driftMm;
    private double capsulePullMm;
    private double rotationDeg;
    private final Map<String, Double> peakN = new LinkedHashMap<>();
    private NeedleLoad load = NeedleLoad.NONE;
    private double pushMm;
    private double sideN;
    private double bendingMm;
    private double[] targetFrom;
    private double[] targetLow = new double[3];
    private double[] targetHigh = targetLow;
    private double targetExcursionMm;
    private double grooveMm = PathAnalyzer.MAX_DISTANCE_MM;

    AttemptLog(Set<NoGoZone> avoided) {
        this.avoided = avoided;
    }

    /** Advances to a frame. Returns the time since the previous frame, s, or 0 for the first frame. */
    double update(Frame frame, RespiratoryPhase phaseLabel) {
        frameS = Double.isNaN(timeS) ? 0 : frame.timeS() - timeS;
        if (frameS < 0) {
            throw new IllegalArgumentException(
                    "found a frame of " + frame.timeS() + " s after one of " + timeS + " s, expected frames in order");
        }
        timeS = frame.timeS();
        int breathNow = 1 + (int) frame.values()[BREATH];
        phaseBefore = breathNow == breath ? phase : 0;
        breath = breathNow;
        phase = frame.values()[PHASE];
        label = phaseLabel;
        return frameS;
    }

    /** Time of the last frame, s. */
    double timeS() {
        return timeS;
    }

    /** Adds an event at the time of the last frame. */
    void event(AttemptEvent.Kind kind, String structure, double depthMm) {
        event(kind, structure, depthMm, timeS);
    }

    /**
     * Adds an event between the last two frames. The phase is interpolated, or starts at 0 if a new breath has begun.
     */
    void event(AttemptEvent.Kind kind, String structure, double depthMm, double when) {
        double before = frameS > 0 ? (timeS - when) / frameS : 0;
        double at = phase - before * (phase - phaseBefore);
        events.add(new AttemptEvent(kind, structure, when, breath, at, label, depthMm));
    }

    /** Starts a new attempt: structures are recorded again when the needle enters them. */
    void newAttempt() {
        entered.clear();
    }

    boolean isFirstEntry(String structure) {
        return entered.add(structure);
    }

    void skinPunctured(double when) {
        insideSinceS = when;
        if (samples.isEmpty()) {
            targetFrom = null;
        }
    }

    void withdrawn() {
        insideS += timeS - insideSinceS;
        insideSinceS = Double.NaN;
        endS = timeS;
    }

    /** Tracks the target from skin puncture to the first sample. */
    void trackTarget(double[] position) {
        if (Double.isNaN(insideSinceS) || !samples.isEmpty()) {
            return;
        }
        if (targetFrom == null) {
            targetFrom = position;
            targetLow = position.clone();
            targetHigh = position.clone();
            targetExcursionMm = 0;
        }
        targetExcursionMm = Math.max(targetExcursionMm, Vectors.distance(position, targetFrom));
        for (int axis = 0; axis < 3; axis++) {
            targetLow[axis] = Math.min(targetLow[axis], position[axis]);
            targetHigh[axis] = Math.max(targetHigh[axis], position[axis]);
        }
    }

    void sampled(TargetingError error) {
        samples.add(error);
        endS = timeS;
    }

    void travelled(double mm) {
        tipTravelMm += mm;
    }

    /** Records that the tissue moved the tip along the needle. */
    void tipDrifted(double mm) {
        driftMm += Math.abs(mm);
    }

    void capsulePulled(double mm, double degrees) {
        capsulePullMm = Math.max(capsulePullMm, mm);
        rotationDeg = Math.max(rotationDeg, degrees);
    }

    /** Records the loads on the needle at the last frame. */
    void loaded(NeedleLoad now) {
        load = now;
        if (!now.layer().isEmpty()) {
            peakN.merge(now.layer(), now.axialN(), Math::max);
        }
        pushMm = Math.max(pushMm, now.capsulePushMm());
        sideN = Math.max(sideN, now.sideN());
        bendingMm = Math.max(bendingMm, now.bendingMm());
    }

    NeedleLoad load() {
        return load;
    }

    private NeedleLoads loads() {
        Map<String, Double> ordered = new LinkedHashMap<>();
        NeedleLoad.LAYERS.stream().filter(peakN::containsKey).forEach(l -> ordered.put(l, peakN.get(l)));
        return new NeedleLoads(ordered, pushMm, sideN, bendingMm, rotationDeg);
    }

    /** Adds time during which the needle lay along a path. */
    void addExposure(PathAnalysis needle, double seconds) {
        needle.noGo().forEach(zone -> secondsIn.merge(zone, seconds, Double::sum));
        inNoGoS += needle.noGo().stream().anyMatch(avoided::contains) ? seconds : 0;
        grooveMm = Math.min(grooveMm, needle.costalGrooveMm());
        Approach.merge(closest, needle.approaches());
    }

    /** Records the throw of a core: the paths to the tip and to the end of the core. It takes no time. */
    void thrown(PathAnalysis toTip, PathAnalysis toEnd) {
        addExposure(toEnd, 0);
        toEnd.noGo().stream().filter(zone -> !toTip.noGo().contains(zone)).forEach(touchedByCore::add);
    }

    List<String> warnings(Optional<PathAnalysis> needle, double pullMm) {
        List<String> warnings = new ArrayList<>();
        needle.ifPresent(n -> warnings.addAll(n.touches(avoided)));
        if (pullMm > AttemptRecord.PULL_WARNING_MM) {
            warnings.add(Numbers.format("the moving liver pulls the capsule %.0f mm aside of the needle", pullMm));
        }
        return warnings;
    }

    AttemptRecord record(TargetLesion target, Needle needle) {
        double beganS = events.isEmpty() ? Double.NaN : events.get(0).timeS();
        return new AttemptRecord(
                target,
                needle,
                Set.copyOf(avoided),
                List.copyOf(samples),
                List.copyOf(events),
                events.isEmpty() ? 0 : (Double.isNaN(endS) ? timeS : endS) - beganS,
                insideS + (Double.isNaN(insideSinceS) ? 0 : timeS - insideSinceS),
                tipTravelMm,
                inNoGoS,
                new ZoneContacts(new EnumMap<>(secondsIn), Set.copyOf(touchedByCore)),
                List.copyOf(closest.values()),
                grooveMm,
                targetExcursionMm,
                Vectors.subtract(targetHigh, targetLow),
                capsulePullMm,
                driftMm,
                loads());
    }
}
