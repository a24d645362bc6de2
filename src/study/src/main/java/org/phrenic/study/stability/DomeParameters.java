package org.phrenic.study.stability;

/** Parameters of a {@link DomeScene}; the defaults are those of Villard, Bourne and Bello 2009. */
final class DomeParameters {
    final DomeMesh mesh;
    /** Stiffness of every spring, N/m. */
    double stiffness = 15;
    /** Viscous damping of every node, N s/m. */
    double viscosity = 0.02;
    /** Mass of every node, kg; the geometric mean if masses differ. */
    double mass = 0.1;
    /** Ratio of the largest to the smallest node mass. */
    double massRatio = 1;
    /** Action line force as a multiple of 300 mN. */
    double force = 1;
    /** Whether each linked pair has three links of different lengths. */
    boolean conflictingLinks;
    /** Whether the rim jumps through its whole range in one step, and back, instead of moving with the breath. */
    boolean rimJumps;
    /** Whether soft springs pull each node to its rest position. */
    boolean homeSprings = true;
    /** Time step, s. */
    double dtS = 0.01;

    DomeParameters(DomeMesh mesh) {
        this.mesh = mesh;
    }
}
