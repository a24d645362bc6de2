package org.phrenic.engine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The constraints of a system: which are enabled, their order, and the number of projection sweeps. */
final class ConstraintSet {
    private final int nodeCount;
    private final List<Constraint> all = new ArrayList<>();
    private Constraint[] active = {};
    /** Projection of all constraints by islands, where possible. */
    private Optional<IslandProjection> islands = Optional.empty();
    /** Otherwise the projection of each constraint, in the same order. */
    private Projector[] projectors = {};

    private int sweeps = 1;

    /** Projects one constraint. */
    @FunctionalInterface
    private interface Projector {
        void project(ParticleSystem system, double h);
    }

    ConstraintSet(int nodeCount) {
        this.nodeCount = nodeCount;
    }

    void add(Constraint constraint) {
        if (contains(constraint)) {
            throw new IllegalArgumentException("constraint: found one that was added before, expected a new one");
        }
        all.add(constraint);
        setEnabled(constraint, true);
    }

    /** Whether this very constraint has been added. */
    private boolean contains(Constraint constraint) {
        return all.stream().anyMatch(added -> added == constraint);
    }

    void setEnabled(Constraint constraint, boolean on) {
        if (!contains(constraint)) {
            throw new IllegalArgumentException(
                    "constraint: found one that was never added, expected one of the system");
        }
        List<Constraint> chosen = new ArrayList<>(Arrays.asList(active));
        chosen.remove(constraint);
        if (on) {
            chosen.add(constraint);
        }
        active = all.stream().filter(chosen::contains).toArray(Constraint[]::new);
        islands = IslandProjection.of(List.of(active), nodeCount);
        projectors = islands.isPresent()
                ? new Projector[0]
                : Arrays.stream(active).map(this::projector).toArray(Projector[]::new);
    }

    private Projector projector(Constraint constraint) {
        if (constraint instanceof CoupledConstraint whole) {
            return whole::project;
        }
        IslandProjection alone = IslandProjection.of(List.of(constraint), nodeCount)
                .orElseThrow(() -> new IllegalArgumentException(
                        "constraint: expected one that is put right as a whole, or item by item"));
        return (system, h) -> alone.project(system, h, 1);
    }

    /** The enabled constraints, in the order they were added. */
    List<Constraint> active() {
        return List.of(active);
    }

    void setSweeps(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("projection sweeps: found " + count + ", expected at least 1");
        }
        sweeps = count;
    }

    void setRefreshInterval(double seconds) {
        all.forEach(constraint -> constraint.setRefreshInterval(seconds));
    }

    void invalidate() {
        all.forEach(Constraint::invalidate);
    }

    boolean hasContacts() {
        return all.stream().anyMatch(Constraint::isContact);
    }

    void project(ParticleSystem system, double time, double h) {
        for (Constraint constraint : active) {
            constraint.prepare(system, time);
        }
        if (islands.isPresent()) {
            islands.get().project(system, h, sweeps);
            return;
        }
        for (int sweep = 0; sweep < sweeps; sweep++) {
            for (Projector stage : projectors) {
                stage.project(system, h);
            }
        }
    }

    void projectVelocities(ParticleSystem system) {
        for (Constraint constraint : active) {
            constraint.projectVelocities(system);
        }
    }

    /** Describes a constraint that the last step could not satisfy; null if all hold. */
    String violation() {
        for (Constraint constraint : active) {
            String cause = constraint.violation();
            if (cause != null) {
                return cause;
            }
        }
        return null;
    }
}
