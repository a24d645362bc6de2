package org.phrenic.study.bare;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * The bare workload as a textbook writes it: an object a node, an object a spring, immutable vectors. What the engine
 * is measured against; symplectic Euler, one thread, no links.
 */
final class ObjectPerNode {
    private record Vector(double x, double y, double z) {
        static final Vector ZERO = new Vector(0, 0, 0);

        Vector plus(Vector o) {
            return new Vector(x + o.x, y + o.y, z + o.z);
        }

        Vector minus(Vector o) {
            return new Vector(x - o.x, y - o.y, z - o.z);
        }

        Vector times(double s) {
            return new Vector(s * x, s * y, s * z);
        }

        double dot(Vector o) {
            return x * o.x + y * o.y + z * o.z;
        }

        double norm() {
            return Math.sqrt(dot(this));
        }
    }

    private static final class Node {
        final boolean fixed;
        final double mass;
        final Vector start;
        Vector load = Vector.ZERO;
        Vector position;
        Vector velocity = Vector.ZERO;
        Vector force = Vector.ZERO;

        Node(Vector position, double mass, boolean fixed) {
            this.start = position;
            this.position = position;
            this.mass = mass;
            this.fixed = fixed;
        }

        void step(double h) {
            if (!fixed) {
                velocity = velocity.plus(force.times(h / mass));
                position = position.plus(velocity.times(h));
            }
        }
    }

    private record Spring(Node a, Node b, double stiffness, double damping, double rest) {
        void pull() {
            Vector line = b.position.minus(a.position);
            double length = line.norm();
            Vector direction = line.times(1 / length);
            double speed = b.velocity.minus(a.velocity).dot(direction);
            Vector force = direction.times(stiffness * (length - rest) + damping * speed);
            a.force = a.force.plus(force);
            b.force = b.force.minus(force);
        }
    }

    private record Edge(int a, int b) {}

    private final List<Node> nodes = new ArrayList<>();
    private final List<Spring> springs = new ArrayList<>();
    private final List<Node> loaded = new ArrayList<>();
    private final double step;

    ObjectPerNode(BareScene scene, BareSettings settings) {
        step = settings.step();
        boolean[] fixed = new boolean[scene.mesh().vertexCount()];
        for (int i : scene.fixed()) {
            fixed[i] = true;
        }
        for (int i = 0; i < fixed.length; i++) {
            Vector place = new Vector(
                    scene.mesh().x(i), scene.mesh().y(i), scene.mesh().z(i));
            nodes.add(new Node(place, settings.mass(), fixed[i]));
        }
        for (int i : scene.loaded()) {
            nodes.get(i).load = new Vector(0, 0, settings.load());
            loaded.add(nodes.get(i));
        }
        Set<Edge> edges = new LinkedHashSet<>();
        int[] t = scene.mesh().triangles();
        for (int i = 0; i < t.length; i++) {
            int a = t[i];
            int b = t[i % 3 == 2 ? i - 2 : i + 1];
            edges.add(new Edge(Math.min(a, b), Math.max(a, b)));
        }
        for (Edge edge : edges) {
            Node a = nodes.get(edge.a());
            Node b = nodes.get(edge.b());
            double rest = b.position.minus(a.position).norm();
            springs.add(new Spring(a, b, settings.stiffness(), settings.damping(), rest));
        }
    }

    void step() {
        for (Node node : nodes) {
            node.force = node.load;
        }
        for (Spring spring : springs) {
            spring.pull();
        }
        for (Node node : nodes) {
            node.step(step);
        }
    }

    double meanDz() {
        return loaded.stream()
                .mapToDouble(n -> n.position.z - n.start.z)
                .average()
                .orElseThrow();
    }
}
