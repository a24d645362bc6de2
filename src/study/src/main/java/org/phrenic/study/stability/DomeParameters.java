package org.phrenic.study.stability;

/**
 * The numbers of a {@link DomeScene}; to begin with those of Villard, Bourne and Bello 2009.
 *
 * @param mesh the sheet
 * @param stiffness of every spring, N/m
 * @param viscosity of every node, N s/m
 * @param mass of every node, kg; the geometric middle where masses differ
 * @param massRatio heaviest over lightest node
 * @param force on the action line over the paper's 300 mN
 * @param conflictingLinks whether each linked pair has three links of three lengths
 * @param rimJumps whether the rim is thrown through its whole range in one step, and back, instead of moving with the
 *     breath
 * @param homeSprings whether soft springs bring each node home
 * @param dtS time step, s
 */
record DomeParameters(
        DomeMesh mesh,
        double stiffness,
        double viscosity,
        double mass,
        double massRatio,
        double force,
        boolean conflictingLinks,
        boolean rimJumps,
        boolean homeSprings,
        double dtS) {

    static DomeParameters published(DomeMesh mesh) {
        return new DomeParameters(mesh, 15, 0.02, 0.1, 1, 1, false, false, true, 0.01);
    }

    DomeParameters stiffer(double factor) {
        return new DomeParameters(
                mesh,
                factor * stiffness,
                viscosity,
                mass,
                massRatio,
                force,
                conflictingLinks,
                rimJumps,
                homeSprings,
                dtS);
    }

    DomeParameters damped(double factor) {
        return new DomeParameters(
                mesh,
                stiffness,
                factor * viscosity,
                mass,
                massRatio,
                force,
                conflictingLinks,
                rimJumps,
                homeSprings,
                dtS);
    }

    DomeParameters uneven(double ratio) {
        return new DomeParameters(
                mesh, stiffness, viscosity, mass, ratio, force, conflictingLinks, rimJumps, homeSprings, dtS);
    }

    DomeParameters pulled(double factor) {
        return new DomeParameters(
                mesh,
                stiffness,
                viscosity,
                mass,
                massRatio,
                factor * force,
                conflictingLinks,
                rimJumps,
                homeSprings,
                dtS);
    }

    DomeParameters inConflict() {
        return new DomeParameters(mesh, stiffness, viscosity, mass, massRatio, force, true, rimJumps, homeSprings, dtS);
    }

    DomeParameters withRimThrown() {
        return new DomeParameters(
                mesh, stiffness, viscosity, mass, massRatio, force, conflictingLinks, true, homeSprings, dtS);
    }

    DomeParameters limp() {
        return new DomeParameters(
                mesh, stiffness, viscosity, mass, massRatio, 0, conflictingLinks, rimJumps, false, dtS);
    }

    DomeParameters slower(double factor) {
        return new DomeParameters(
                mesh,
                stiffness,
                viscosity,
                mass,
                massRatio,
                force,
                conflictingLinks,
                rimJumps,
                homeSprings,
                factor * dtS);
    }
}
