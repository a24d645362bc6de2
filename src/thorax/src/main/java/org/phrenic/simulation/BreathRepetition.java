package org.phrenic.simulation;

import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.LiveBreathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * Repeats a steady breath from its record instead of simulating it again ({@link Breathing#REPEAT}).
 *
 * <p>The body is a damped system that the breath drives: its states converge to a periodic motion. If no node is
 * farther than {@value #TOLERANCE_MM} mm from where it was a period before, the next periods follow the last one within
 * about this distance, and repeat its record until a setting changes. A hold is a change too: it is simulated until no
 * node moves by more than {@value #STILL_MM} mm in {@value #STILL_S} s, then the body stands still. After the hold the
 * record counts as soon as all nodes are within the tolerance of it again; what is left of the difference is faded out
 * over a period.
 *
 * <p>Whether and from which step on a record is repeated depends on the state, the step and the changes alone, so that
 * equal runs give equal bits.
 */
final class BreathRepetition {
    /** Distance of a coordinate from the record within which the record counts, mm. */
    static final double TOLERANCE_MM = 0.05;

    /** Motion of a coordinate in {@value #STILL_S} s below which a held body stands still, mm. */
    static final double STILL_MM = 0.02;

    private static final double STILL_S = 0.5;

    /** Time between samples of a record, s. */
    private static final double INTERVAL_S = 0.02;

    /** Time after a change of settings in which nothing is recorded: that of all ramps, 0.2 s, and more, s. */
    private static final double SETTLING_S = 0.5;

    /** Largest record, bytes; longer ones are not made. */
    private static final double MAX_BYTES = 400e6;

    private final Stepper stepper;
    private final ParticleSystem system;
    private final LiveBreathing breathing;
    private boolean on;
    private RecordedBreath whole;
    private RecordedBreath begun;
    private Playback playing;
    private long notBefore;
    private long nextSample;
    private long repeated;
    private double[] heldAt = {};
    private long heldSince;

    /** Writes the state at a time into the system. */
    @FunctionalInterface
    private interface Playback {
        void write(double timeS);
    }

    BreathRepetition(Scenario start, Scene scene, Stepper stepper) {
        this.stepper = stepper;
        system = scene.system();
        breathing = scene.drive().pattern();
        on = start.get(Breathing.REPEAT);
    }

    boolean isRepeating() {
        return playing != null;
    }

    /** Number of steps since the start that were repeated. */
    long repeatedSteps() {
        return repeated;
    }

    /** Makes the next step from the record; returns false if it has to be simulated. */
    boolean step() {
        if (playing == null) {
            return false;
        }
        stepper.acceptStep();
        playing.write(stepper.time());
        repeated++;
        return true;
    }

    /** To be called after each change of settings. */
    void changed(Scenario now, List<Assignment> changes) {
        on = now.get(Breathing.REPEAT);
        playing = null;
        beginAnew();
        boolean holdOnly = changes.stream().allMatch(change -> change.setting() == Breathing.HOLD);
        if (!on || !holdOnly) {
            whole = null;
            notBefore = stepper.steps() + Math.round(SETTLING_S / stepper.dt());
        }
    }

    /** To be called after each step that was simulated. */
    void stepped() {
        if (!on || stepper.steps() < notBefore) {
            return;
        }
        double now = stepper.time();
        double rate = breathing.rate(now);
        if (rate == 1) {
            goOn(now);
        } else if (rate == 0) {
            hold();
        } else {
            beginAnew();
        }
    }

    /** Drops the record that is being made and what is known of the motion in a hold. */
    private void beginAnew() {
        begun = null;
        heldAt = new double[0];
    }

    /** Records the breath, or returns to its record. */
    private void goOn(double now) {
        long every = Math.max(1, Math.round(INTERVAL_S / stepper.dt()));
        boolean isNext = begun != null && stepper.steps() == nextSample;
        if (!isNext && stepper.steps() % every != 0) {
            return;
        }
        nextSample = stepper.steps() + every;
        if (whole != null) {
            joinIfNear(now);
            return;
        }
        double periodS = breathing.patternPeriodS();
        double intervalS = every * stepper.dt();
        if (!(periodS > 2 * intervalS) || bytes(periodS / intervalS) > MAX_BYTES) {
            return;
        }
        if (!isNext) {
            begun = new RecordedBreath(breathing.patternTimeS(now), periodS, intervalS);
        }
        begun.add(system.positions());
        if (begun.close(TOLERANCE_MM)) {
            whole = begun;
            begun = null;
            joinIfNear(now);
        }
    }

    private double bytes(double samples) {
        return 4.0 * samples * system.positions().length;
    }

    /** Repeats the record from now on if all nodes are near it. */
    private void joinIfNear(double now) {
        double[] x = system.positions();
        double[] off = new double[x.length];
        whole.at(breathing.patternTimeS(now), off, new double[x.length]);
        if (!isNear(x, off, TOLERANCE_MM)) {
            return;
        }
        for (int i = 0; i < off.length; i++) {
            off[i] = x[i] - off[i];
        }
        RecordedBreath record = whole;
        playing = timeS -> {
            record.at(breathing.patternTimeS(timeS), system.positions(), system.velocities());
            double left = 1 - (timeS - now) / record.periodS();
            for (int i = 0; left > 0 && i < off.length; i++) {
                system.positions()[i] += left * off[i];
                system.velocities()[i] -= off[i] / record.periodS();
            }
        };
    }

    /** Lets a held body stand still once it does not move any more. */
    private void hold() {
        begun = null;
        double[] x = system.positions();
        boolean watched = heldAt.length > 0;
        if (watched && (stepper.steps() - heldSince) * stepper.dt() < STILL_S) {
            return;
        }
        if (watched && isNear(x, heldAt, STILL_MM)) {
            playing = timeS -> Arrays.fill(system.velocities(), 0);
        }
        heldAt = x.clone();
        heldSince = stepper.steps();
    }

    /** Whether no coordinate differs by more than a distance; false where one is not a number. */
    private static boolean isNear(double[] a, double[] b, double mm) {
        for (int i = 0; i < a.length; i++) {
            if (!(Math.abs(a[i] - b[i]) <= mm)) {
                return false;
            }
        }
        return true;
    }
}
