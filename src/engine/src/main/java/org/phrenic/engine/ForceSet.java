package org.phrenic.engine;

import java.util.ArrayList;
import java.util.List;

/** The force fields of a system, and those enabled in the order they were added. */
final class ForceSet {
    private final List<ForceField> all = new ArrayList<>();
    private ForceField[] active = {};
    private boolean dependsOnVelocity;

    void add(ForceField field) {
        if (contains(field)) {
            throw new IllegalArgumentException("force field: found one that was added before, expected a new one");
        }
        all.add(field);
        setEnabled(field, true);
    }

    /** Whether this very field has been added. */
    private boolean contains(ForceField field) {
        return all.stream().anyMatch(added -> added == field);
    }

    void setEnabled(ForceField field, boolean on) {
        if (!contains(field)) {
            throw new IllegalArgumentException(
                    "force field: found one that was never added, expected one of the system");
        }
        List<ForceField> chosen = new ArrayList<>(List.of(active));
        chosen.remove(field);
        if (on) {
            chosen.add(field);
        }
        active = all.stream().filter(chosen::contains).toArray(ForceField[]::new);
        dependsOnVelocity = chosen.stream().anyMatch(ForceField::dependsOnVelocity);
    }

    List<ForceField> active() {
        return List.of(active);
    }

    boolean dependsOnVelocity() {
        return dependsOnVelocity;
    }

    void invalidate() {
        all.forEach(ForceField::invalidate);
    }

    void saveHistory() {
        all.forEach(ForceField::saveHistory);
    }

    void restoreHistory() {
        all.forEach(ForceField::restoreHistory);
    }

    void setRefreshInterval(double seconds) {
        all.forEach(field -> field.setRefreshInterval(seconds));
    }

    void prepare(double time) {
        for (ForceField field : active) {
            field.prepare(time);
        }
    }

    /** Prepares the fields that act on a range of blocks. */
    void prepare(double time, int from, int end) {
        for (ForceField field : active) {
            if (field.actsOn(from, end)) {
                field.prepare(time, from, end);
            }
        }
    }

    void addForces(double[] position, double[] velocity, double[] force, int block) {
        for (ForceField field : active) {
            field.addForces(position, velocity, force, block);
        }
    }

    void addStiffness(double[] position, double[] u, double[] out, int block) {
        for (ForceField field : active) {
            field.addStiffness(position, u, out, block);
        }
    }

    void addRowSums(double[] position, double[] stiffness, double[] damping) {
        for (ForceField field : active) {
            field.addRowSums(position, stiffness, damping);
        }
    }

    double potentialEnergy(double[] position) {
        double sum = 0;
        for (ForceField field : active) {
            sum += field.potentialEnergy(position);
        }
        return sum;
    }
}
