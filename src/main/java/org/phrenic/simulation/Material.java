package org.phrenic.simulation;

import java.util.Locale;

/** What the springs of the diaphragm stand for. */
public enum Material {
    /** A membrane under transdiaphragmatic pressure: stiffness, mass and damping a unit of area, muscle that shortens. */
    PHYSICAL,
    /** Villard, Bourne and Bello 2009: one stiffness for every spring, one mass for every node, muscle force along action lines. */
    PAPER;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
