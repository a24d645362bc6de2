package org.phrenic.engine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The constraints of a system: which are switched on, in which order and how often they are put right. */
final class ConstraintSet {
    private final int nodeCount;
    private final List<Constraint> all = new ArrayList<>();
    private Constraint[] active = {};
    /** Those of them that share nodes with another. */
    private Constraint[] entangled = {};

    private int sweeps = 1;

    ConstraintSet(int nodeCount) {
        this.nodeCount = nodeCount;
    }

    void add(Constraint constraint) {
        all.add(constraint);
        setEnabled(constraint, true);
    }

    void setEnabled(Constraint constraint, boolean on) {
        List<Constraint> chosen = new ArrayList<>(Arrays.asList(active));
        chosen.remove(constraint);
        if (on) {
            chosen.add(constraint);
        }
        active = all.stream().filter(chosen::contains).toArray(Constraint[]::new);
        int[] movers = new int[nodeCount];
        for (Constraint each : active) {
            each.nodes().map(n -> n / 3).distinct().forEach(n -> movers[n]++);
        }
        entangled = Arrays.stream(active)
                .filter(each -> each.nodes().anyMatch(n -> movers[n / 3] > 1))
                .toArray(Constraint[]::new);
    }

    /** Those switched on, in the order they were added. */
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

    void forget() {
        all.forEach(Constraint::forget);
    }

    boolean hasWalls() {
        return all.stream().anyMatch(Constraint::isWall);
    }

    /** One sweep over all that are switched on, the others over those that share nodes: what alone moves its nodes holds after the first. */
    void project(ParticleSystem system, double time, double h) {
        for (Constraint constraint : active) {
            constraint.prepare(time);
        }
        for (Constraint constraint : active) {
            constraint.project(system, h);
        }
        for (int sweep = 1; sweep < sweeps; sweep++) {
            for (Constraint constraint : entangled) {
                constraint.project(system, h);
            }
        }
    }

    void projectVelocities(ParticleSystem system) {
        for (Constraint constraint : active) {
            constraint.projectVelocities(system);
        }
    }

    /** What one of them could not make hold in the last step; null where all hold. */
    String unmet() {
        for (Constraint constraint : active) {
            String cause = constraint.unmet();
            if (cause != null) {
                return cause;
            }
        }
        return null;
    }
}
