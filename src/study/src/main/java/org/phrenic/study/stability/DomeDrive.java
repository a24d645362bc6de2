package org.phrenic.study.stability;

import org.phrenic.engine.ForceField;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.force.ActionLine;

/**
 * Periodic drive of a {@link DomeScene} with a period of 4 s. In each period the action line pulls, and the rim widens
 * by a twelfth and rises 8 mm. The rim moves smoothly or jumps. The drive adds no forces of its own.
 */
final class DomeDrive implements ForceField, PrescribedMotion {
    static final double PERIOD_S = 4;
    private static final double WIDENING = 1.0 / 12;
    private static final double RISE_MM = 8;

    private final DomeParameters parameters;
    private final ActionLine line;
    private final double lineForce;
    private final double[] rim;

    /**
     * @param lineForce of the action line at full drive, mN
     * @param rim rest positions of the rim, mm
     */
    DomeDrive(DomeParameters parameters, ActionLine line, double lineForce, double[] rim) {
        this.parameters = parameters;
        this.line = line;
        this.lineForce = lineForce;
        this.rim = rim.clone();
    }

    private static double drive(double time) {
        return 0.5 - 0.5 * StrictMath.cos(2 * Math.PI * time / PERIOD_S);
    }

    private static double driveRate(double time) {
        return Math.PI / PERIOD_S * StrictMath.sin(2 * Math.PI * time / PERIOD_S);
    }

    @Override
    public void prepare(double time) {
        line.setForce(parameters.force * lineForce * drive(time));
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {}

    @Override
    public int pointCount() {
        return rim.length / 3;
    }

    @Override
    public void at(double time, double[] position, double[] velocity) {
        double phase = time / PERIOD_S - Math.floor(time / PERIOD_S);
        boolean out = parameters.rimJumps && phase >= 0.25 && phase < 0.75;
        double turn = parameters.rimJumps ? (out ? 1 : 0) : drive(time);
        double rate = parameters.rimJumps ? 0 : driveRate(time);
        for (int i = 0; i < rim.length; i++) {
            double range = i % 3 == 2 ? RISE_MM : WIDENING * rim[i];
            position[i] = rim[i] + turn * range;
            velocity[i] = rate * range;
        }
    }
}
