package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.EnumMap;
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
import org.phrenic.mesh.Vectors;

/** What is gathered while an attempt goes on. */
final class AttemptLog {
    private final Set<NoGoZone> avoided;
    private final List<AttemptEvent> events = new ArrayList<>();
    private final List<TargetingError> samples = new ArrayList<>();
    private final Set<String> entered = new LinkedHashSet<>();
    private final EnumMap<NoGoZone, Double> secondsIn = new EnumMap<>(NoGoZone.class);
    private final Map<String, Approach> closest = new TreeMap<>();
    private double inNoGoS;
    private double begunS = Double.NaN;
    private double insideSinceS = Double.NaN;
    private double insideS;
    private double lastS = Double.NaN;
    private double travelledMm;
    private double slipMm;
    private double pullMm;
    private double swingDeg;
    private double[] targetFrom;
    private double[] targetLow;
    private double[] targetHigh;
    private double targetMovedMm;
    private double borderMm = PathAnalyzer.MAX_DISTANCE_MM;
    private boolean sampled;

    AttemptLog(Set<NoGoZone> avoided) {
        this.avoided = avoided;
    }

    void add(AttemptEvent event) {
        events.add(event);
        if (Double.isNaN(begunS)) {
            begunS = event.timeS();
        }
    }

    /** Structures are entered anew. */
    void newAttempt() {
        entered.clear();
    }

    boolean isFirstEntry(String structure) {
        return entered.add(structure);
    }

    void skinPunctured(double when) {
        insideSinceS = when;
        if (!sampled) {
            targetFrom = null;
        }
    }

    void withdrawn(double when) {
        insideS += when - insideSinceS;
        insideSinceS = Double.NaN;
        lastS = when;
    }

    /** The target's way counts from the puncture of the skin to the last sample. */
    void trackTarget(double[] now) {
        if (Double.isNaN(insideSinceS) || sampled) {
            return;
        }
        if (targetFrom == null) {
            targetFrom = now;
            targetLow = now.clone();
            targetHigh = now.clone();
            targetMovedMm = 0;
        }
        targetMovedMm = Math.max(targetMovedMm, Vectors.distance(now, targetFrom));
        for (int axis = 0; axis < 3; axis++) {
            targetLow[axis] = Math.min(targetLow[axis], now[axis]);
            targetHigh[axis] = Math.max(targetHigh[axis], now[axis]);
        }
    }

    void sampled(TargetingError miss, double when) {
        samples.add(miss);
        sampled = true;
        lastS = when;
    }

    void travelled(double mm) {
        travelledMm += mm;
    }

    /** The tissue has taken the tip deeper or less deep. */
    void tipDrifted(double mm) {
        slipMm += Math.abs(mm);
    }

    void capsulePulled(double mm, double degrees) {
        pullMm = Math.max(pullMm, mm);
        swingDeg = Math.max(swingDeg, degrees);
    }

    /** The shaft was so for some time. */
    void addExposure(PathAnalysis shaft, double seconds) {
        boolean any = false;
        for (NoGoZone one : shaft.noGo()) {
            secondsIn.merge(one, seconds, Double::sum);
            any |= avoided.contains(one);
        }
        inNoGoS += any ? seconds : 0;
        borderMm = Math.min(borderMm, shaft.costalGrooveMm());
        for (Approach a : shaft.approaches()) {
            closest.merge(a.name(), a, (x, y) -> y.distanceMm() < x.distanceMm() ? y : x);
        }
    }

    List<String> warnings(Optional<PathAnalysis> shaft, double pull) {
        List<String> words = new ArrayList<>(shaft.map(s -> s.reasons(avoided)).orElse(List.of()));
        if (pull > AttemptRecord.PULL_WARNING_MM) {
            words.add(String.format(
                    java.util.Locale.ROOT, "the moving liver pulls the capsule %.0f mm aside of the needle", pull));
        }
        return words;
    }

    AttemptRecord record(TargetLesion target, Needle needle, double nowS) {
        double inside = insideS + (Double.isNaN(insideSinceS) ? 0 : nowS - insideSinceS);
        double[] range = new double[3];
        if (targetLow != null) {
            range = Vectors.subtract(targetHigh, targetLow);
        }
        return new AttemptRecord(
                target,
                needle,
                Set.copyOf(avoided),
                List.copyOf(samples),
                List.copyOf(events),
                Double.isNaN(begunS) ? 0 : (Double.isNaN(lastS) ? nowS : lastS) - begunS,
                inside,
                travelledMm,
                inNoGoS,
                new EnumMap<>(secondsIn),
                List.copyOf(closest.values()),
                borderMm,
                targetMovedMm,
                range,
                pullMm,
                swingDeg,
                slipMm);
    }
}
