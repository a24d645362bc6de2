package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A recorded breath, repeated, with the {@link Unsteadiness} that the record lacks. What deforms but the skin is
 * displaced along its own way from end-expiration to the moment when the target is farthest from there, in proportion,
 * so that the target is displaced by the given distance; along the axis from head to foot if the target moves by less
 * than {@value #LEAST_MM} mm. Bones and skin are not displaced. Not thread-safe.
 */
final class RepeatedBreath {
    /**
     * Motion besides the repeated breath, as displacement of the target along its way in the breath.
     *
     * @param levelMm standard deviation of the level at end-expiration from breath to breath, mm; between two it
     *     changes in proportion to time
     * @param beatMm amplitude of the heartbeat, mm
     * @param beatHz its frequency, Hz
     * @param driftMmPerS drift toward the head in a held breath, mm/s
     */
    record Unsteadiness(double levelMm, double beatMm, double beatHz, double driftMmPerS) {
        static final Unsteadiness NONE = new Unsteadiness(0, 0, 1, 0);
    }

    /** Motion of the target below which its way, and that of others in proportion to it, says nothing, mm; chosen. */
    private static final double LEAST_MM = 1;

    private final List<BreathMoment> breath;
    private final double periodS;
    private final Unsteadiness unsteadiness;
    private final Frame frame;
    /** Displacement of each surface for 1 mm of the target; empty for those that are not displaced. */
    private final float[][] way;

    /** Distance of the target from its place at end-expiration at each moment, mm. */
    private final double[] awayMm;

    private final List<Double> levels = new ArrayList<>();
    private Random random = new Random(0);
    private double startS;
    private double beatFrom;
    private double stoppedS;

    RepeatedBreath(MovingAnatomy anatomy, AccessMap map, Unsteadiness unsteadiness) {
        breath = map.cycle();
        int n = breath.size();
        periodS = n > 1 ? (breath.get(1).timeS() - breath.get(0).timeS()) * n : 1;
        this.unsteadiness = unsteadiness;
        frame = breath.get(0).frame().copy();
        int farthest = 0;
        awayMm = new double[n];
        for (int m = 0; m < n; m++) {
            awayMm[m] = Vectors.distance(map.target(0), map.target(m));
            farthest = awayMm[m] > awayMm[farthest] ? m : farthest;
        }
        double mm = awayMm[farthest];
        way = new float[anatomy.structures().size()][];
        Frame to = breath.get(farthest).frame();
        for (int s = 0; s < way.length; s++) {
            Surface surface = anatomy.structures().get(s).surface();
            boolean moves = surface.motion() == Surface.Motion.DEFORMING && surface.kind() != StructureKind.SKIN;
            way[s] = new float[moves ? to.positions(s).length : 0];
            for (int i = 0; i < way[s].length; i++) {
                float toFoot = i % 3 == 2 ? -1 : 0;
                way[s][i] = mm < LEAST_MM ? toFoot : (float) ((to.positions(s)[i] - frame.positions(s)[i]) / mm);
            }
        }
    }

    /** Duration of the breath, s. */
    double periodS() {
        return periodS;
    }

    /** Begins anew, at a time within the breath that the seed decides. */
    void begin(long seed) {
        random = new Random(seed);
        startS = random.nextDouble() * periodS;
        beatFrom = random.nextDouble();
        levels.clear();
        stoppedS = Double.POSITIVE_INFINITY;
    }

    /** Holds the breath from a time on. */
    void holdFrom(double timeS) {
        stoppedS = timeS;
    }

    /** What the breath does at a time after its beginning; it may lie before it. */
    RespiratoryPhase label(double timeS) {
        return timeS > stoppedS
                ? RespiratoryPhase.HOLD
                : breath.get(moment(timeS)).label();
    }

    /** The body at a time after its beginning, in a frame that is used again. */
    Frame at(double timeS) {
        BreathMoment now = breath.get(moment(timeS));
        long serial = frame.serial();
        long step = frame.step();
        frame.copyFrom(now.frame());
        frame.setState(serial + 1, step + 1, timeS, now.frame().values());
        float mm = (float) displacement(timeS);
        for (int s = 0; s < way.length; s++) {
            float[] positions = frame.positions(s);
            for (int i = 0; i < way[s].length; i++) {
                positions[i] += mm * way[s][i];
            }
        }
        return frame;
    }

    private double displacement(double timeS) {
        double breaths = (startS + Math.min(timeS, stoppedS)) / periodS;
        int whole = (int) Math.max(0, Math.floor(breaths));
        double share = breaths - whole;
        double level = (1 - share) * level(whole) + share * level(whole + 1);
        double beat = StrictMath.sin(2 * Math.PI * (beatFrom + unsteadiness.beatHz() * timeS));
        return level + unsteadiness.beatMm() * beat - unsteadiness.driftMmPerS() * Math.max(0, timeS - stoppedS);
    }

    private double level(int number) {
        while (levels.size() <= number) {
            levels.add(unsteadiness.levelMm() * random.nextGaussian());
        }
        return levels.get(number);
    }

    /** Distance of the target from its recorded place at end-expiration along its way, mm. */
    double awayMm(double timeS) {
        return awayMm[moment(timeS)] + displacement(timeS);
    }

    /** Index of the recorded moment at or before a time. */
    private int moment(double timeS) {
        double into = (startS + Math.min(timeS, stoppedS)) % periodS;
        double share = (into < 0 ? into + periodS : into) / periodS;
        return Math.min(breath.size() - 1, (int) (share * breath.size()));
    }
}
