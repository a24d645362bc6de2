package org.phrenic.model.organ;

import java.util.Arrays;

/**
 * Growing list of springs during assembly: two nodes, a stiffness (N/m), a rest length (mm) and a contractile share
 * each.
 */
public final class SpringList {
    private int[] nodeA = new int[1024];
    private int[] nodeB = new int[1024];
    private double[] stiffness = new double[1024];
    private double[] rest = new double[1024];
    private double[] contractileShare = new double[1024];
    private int count;

    public void add(int a, int b, double k, double length, double contractile) {
        if (count == nodeA.length) {
            int more = 2 * count;
            nodeA = Arrays.copyOf(nodeA, more);
            nodeB = Arrays.copyOf(nodeB, more);
            stiffness = Arrays.copyOf(stiffness, more);
            rest = Arrays.copyOf(rest, more);
            contractileShare = Arrays.copyOf(contractileShare, more);
        }
        nodeA[count] = a;
        nodeB[count] = b;
        stiffness[count] = k;
        rest[count] = length;
        contractileShare[count] = contractile;
        count++;
    }

    /**
     * Adds a spring between vertices a and b of a surface, with their distance as rest length.
     *
     * @param p positions of the surface's vertices, mm
     * @param first node of its first vertex
     */
    public void addEdge(double[] p, int first, int a, int b, double k, double contractile) {
        add(first + a, first + b, k, MassSpringBuilder.distance(p, a, p, b), contractile);
    }

    public int count() {
        return count;
    }

    public int[] nodeA() {
        return Arrays.copyOf(nodeA, count);
    }

    public int[] nodeB() {
        return Arrays.copyOf(nodeB, count);
    }

    public double[] stiffness() {
        return Arrays.copyOf(stiffness, count);
    }

    public double[] rest() {
        return Arrays.copyOf(rest, count);
    }

    public double[] contractileShare() {
        return Arrays.copyOf(contractileShare, count);
    }

    /** Sets the rest length of spring i, mm. */
    public void setRest(int i, double length) {
        rest[i] = length;
    }
}
