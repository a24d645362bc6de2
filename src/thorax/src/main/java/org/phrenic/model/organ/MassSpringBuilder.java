package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.mesh.TriangleMesh;

/** Collects the nodes and springs of a scene while its parts are added in turn. */
public final class MassSpringBuilder {
    private final List<TriangleMesh> meshes = new ArrayList<>();
    private final List<Integer> firstNode = new ArrayList<>();
    private double[] mass = new double[0];
    private int nodes;

    /** Springs of the diaphragm, contractile and passive. One prestress holds them in shape. */
    public final SpringList sheetSprings = new SpringList();
    /** All other springs. */
    public final SpringList passiveSprings = new SpringList();

    /** Attachments to bone: node, stiffness (N/m). */
    private final List<Integer> attachedNode = new ArrayList<>();

    private final List<Double> attachedStiffness = new ArrayList<>();

    /**
     * Adds the vertices of a surface as nodes.
     *
     * @param masses one per vertex, kg
     * @return number of the first node
     */
    public int addNodes(TriangleMesh mesh, double[] masses) {
        int first = nodes;
        meshes.add(mesh);
        firstNode.add(first);
        nodes += mesh.vertexCount();
        mass = Arrays.copyOf(mass, nodes);
        System.arraycopy(masses, 0, mass, first, masses.length);
        return first;
    }

    public void attachToBone(int node, double stiffness) {
        attachedNode.add(node);
        attachedStiffness.add(stiffness);
    }

    public int nodeCount() {
        return nodes;
    }

    public double[] masses() {
        return mass;
    }

    public double[] positions() {
        double[] out = new double[3 * nodes];
        for (int i = 0; i < meshes.size(); i++) {
            double[] p = meshes.get(i).positions();
            System.arraycopy(p, 0, out, 3 * firstNode.get(i), p.length);
        }
        return out;
    }

    public int[] attachedNodes() {
        return attachedNode.stream().mapToInt(Integer::intValue).toArray();
    }

    public double[] attachedStiffnesses() {
        return attachedStiffness.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Converts vertices of a surface to node numbers. */
    public static int[] offset(int[] vertices, int first) {
        return Arrays.stream(vertices).map(i -> first + i).toArray();
    }

    public static int[] concatenate(int[] a, int[] b) {
        int[] out = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, out, a.length, b.length);
        return out;
    }

    /** Positions of some vertices of the surface whose first node is {@code first}. */
    public static double[] positionsOf(double[] positions, int first, int[] vertices) {
        double[] out = new double[3 * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(positions, 3 * (first + vertices[i]), out, 3 * i, 3);
        }
        return out;
    }

    public static double distance(double[] p, int a, double[] q, int b) {
        double x = p[3 * a] - q[3 * b];
        double y = p[3 * a + 1] - q[3 * b + 1];
        double z = p[3 * a + 2] - q[3 * b + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }
}
