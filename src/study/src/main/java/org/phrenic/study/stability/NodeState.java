package org.phrenic.study.stability;

import org.phrenic.engine.ParticleSystem;

/** Node positions and speeds of a scene, in the caller's order. */
final class NodeState {
    private final ParticleSystem system;
    private final double[] positions;

    NodeState(ParticleSystem system) {
        this.system = system;
        positions = new double[3 * system.nodeCount()];
    }

    /** Current positions, mm; the array is reused. */
    double[] positions() {
        system.layout().toCaller(system.positions(), positions);
        return positions;
    }

    /** Rms distance of the nodes, mm. */
    static double rmsDistance(double[] p, double[] q) {
        double sum = 0;
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (p[i] - q[i]);
        }
        return Math.sqrt(3 * sum / p.length);
    }

    /** Largest distance of a node, mm; NaN if a position is NaN. */
    static double maxDistance(double[] p, double[] q) {
        double worst = 0;
        for (int i = 0; i < p.length; i += 3) {
            double dx = p[i] - q[i];
            double dy = p[i + 1] - q[i + 1];
            double dz = p[i + 2] - q[i + 2];
            worst = Math.max(worst, dx * dx + dy * dy + dz * dz);
        }
        return Math.sqrt(worst);
    }

    /** Largest speed of a node, mm/s; NaN if a speed is NaN. */
    double maxSpeed() {
        double[] v = system.velocities();
        double worst = 0;
        for (int i = 0; i < v.length; i += 3) {
            worst = Math.max(worst, v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
        }
        return Math.sqrt(worst);
    }
}
