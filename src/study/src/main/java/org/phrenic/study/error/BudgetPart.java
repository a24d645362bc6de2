package org.phrenic.study.error;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** A part of the error budget. Each is measured by itself. */
public enum BudgetPart {
    /** Distance from the same discrete model with a short time step. */
    TIME,
    /** Excursion of the domes on meshes of different edge lengths. */
    SPACE,
    /** Distance from quasi-static equilibrium at four phases of a breath. */
    EQUILIBRIUM,
    /** Convergence in time of a whole scene, with and without contact. */
    ORDER,
    /** Distance between the explicit solution and an implicit one, with scaled and with true masses. */
    IMPLICIT;

    /** Name on the command line and in files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** All names, separated by commas. */
    public static String labels() {
        return Arrays.stream(values()).map(BudgetPart::label).collect(Collectors.joining(", "));
    }

    /** The part of a name, if there is one. */
    public static Optional<BudgetPart> of(String label) {
        return Arrays.stream(values()).filter(p -> p.label().equals(label)).findFirst();
    }
}
