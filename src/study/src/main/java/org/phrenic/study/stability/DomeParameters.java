package org.phrenic.study.stability;

/** The numbers of a {@link DomeScene}; the defaults are those of Villard, Bourne and Bello 2009. */
final class DomeParameters {
    final DomeMesh mesh;
    /** Of every spring, N/m. */
    double stiffness = 15;
    /** Of every node, N s/m. */
    double viscosity = 0.02;
    /** Of every node, kg; the geometric mean where masses differ. */
    double mass = 0.1;
    /** Heaviest over lightest node. */
    double massRatio = 1;
    /** On the action line over the paper's 300 mN. */
    double force = 1;
    /** Whether each linked pair has three links of three lengths. */
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
