package org.phrenic.study.hard;

/**
 * The numbers of a {@link Dome}; to begin with those of Villard, Bourne and Bello 2009.
 *
 * @param mesh the sheet
 * @param stiffness of every spring, N/m
 * @param viscosity of every node, N s/m
 * @param mass of every node, kg; the geometric middle where masses differ
 * @param massRatio heaviest over lightest node
 * @param force on the action line over the paper's 300 mN
 * @param conflicting whether each linked pair has three links of three lengths
 * @param thrown whether the rim is thrown through its whole range in one step, and back, instead of moving with the breath
 * @param held whether soft springs bring each node home
 * @param dtS time step, s
 */
record DomeRecipe(
        DomeMesh mesh,
        double stiffness,
        double viscosity,
        double mass,
        double massRatio,
        double force,
        boolean conflicting,
        boolean thrown,
        boolean held,
        double dtS) {

    static DomeRecipe published(DomeMesh mesh) {
        return new DomeRecipe(mesh, 15, 0.02, 0.1, 1, 1, false, false, true, 0.01);
    }

    DomeRecipe stiffer(double factor) {
        return new DomeRecipe(
                mesh, factor * stiffness, viscosity, mass, massRatio, force, conflicting, thrown, held, dtS);
    }

    DomeRecipe damped(double factor) {
        return new DomeRecipe(
                mesh, stiffness, factor * viscosity, mass, massRatio, force, conflicting, thrown, held, dtS);
    }

    DomeRecipe uneven(double ratio) {
        return new DomeRecipe(mesh, stiffness, viscosity, mass, ratio, force, conflicting, thrown, held, dtS);
    }

    DomeRecipe pulled(double factor) {
        return new DomeRecipe(
                mesh, stiffness, viscosity, mass, massRatio, factor * force, conflicting, thrown, held, dtS);
    }

    DomeRecipe inConflict() {
        return new DomeRecipe(mesh, stiffness, viscosity, mass, massRatio, force, true, thrown, held, dtS);
    }

    DomeRecipe withRimThrown() {
        return new DomeRecipe(mesh, stiffness, viscosity, mass, massRatio, force, conflicting, true, held, dtS);
    }

    DomeRecipe limp() {
        return new DomeRecipe(mesh, stiffness, viscosity, mass, massRatio, 0, conflicting, thrown, false, dtS);
    }

    DomeRecipe slower(double factor) {
        return new DomeRecipe(
                mesh, stiffness, viscosity, mass, massRatio, force, conflicting, thrown, held, factor * dtS);
    }
}
