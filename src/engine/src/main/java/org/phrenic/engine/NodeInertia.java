package org.phrenic.engine;

import java.util.Arrays;
import org.phrenic.engine.parallel.NodeLayout;

/** Mass, inverse mass and viscous damping of each node of a system; arrays are in internal order. */
final class NodeInertia {
    /** kg. */
    final double[] mass;
    /** 1/kg; 0 for nodes with prescribed motion. */
    final double[] inverse;
    /** Viscous damping γ, N s/m. */
    final double[] viscosity;

    private final NodeLayout layout;

    /** @throws IllegalArgumentException if a mass is not positive and finite */
    NodeInertia(NodeLayout layout, double[] callerMasses) {
        this.layout = layout;
        int n = layout.nodeCount();
        mass = new double[n];
        inverse = new double[n];
        viscosity = new double[n];
        for (int i = 0; i < n; i++) {
            check(i, callerMasses[layout.caller(i)]);
            mass[i] = callerMasses[layout.caller(i)];
            inverse[i] = 1 / mass[i];
        }
    }

    private void check(int node, double kg) {
        if (!(kg > 0) || Double.isInfinite(kg)) {
            throw new IllegalArgumentException(
                    "mass of node " + layout.caller(node) + ": found " + kg + " kg, expected more than 0");
        }
    }

    /** @throws IllegalArgumentException if the mass is not positive and finite */
    void set(int node, double kg) {
        check(node, kg);
        mass[node] = kg;
        if (inverse[node] > 0) {
            inverse[node] = 1 / kg;
        }
    }

    /** Gives nodes whose motion was prescribed their inverse mass back. */
    void release(int[] nodes) {
        for (int node : nodes) {
            inverse[node] = 1 / mass[node];
        }
    }

    /** Takes the inverse mass from nodes whose motion is prescribed. */
    void hold(int[] nodes) {
        for (int node : nodes) {
            inverse[node] = 0;
        }
    }

    /** @throws IllegalArgumentException if the value is negative or not finite */
    void setViscosity(double gamma) {
        checkDamping("viscosity", gamma, "N s/m");
        Arrays.fill(viscosity, gamma);
    }

    /** @throws IllegalArgumentException if the rate is negative or not finite */
    void setViscosityPerMass(double rate) {
        checkDamping("viscosity per mass", rate, "1/s");
        for (int i = 0; i < viscosity.length; i++) {
            viscosity[i] = rate * mass[i];
        }
    }

    private static void checkDamping(String what, double value, String unit) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(what + ": found " + value + " " + unit + ", expected 0 or more");
        }
    }
}
