package org.phrenic.simulation;

import java.util.Arrays;

/** Springs as they are collected while a scene is put together: two nodes, a stiffness (N/m), a rest length (mm) and a contractile share each. */
final class SpringList {
    private int[] nodeA = new int[1024];
    private int[] nodeB = new int[1024];
    private double[] stiffness = new double[1024];
    private double[] rest = new double[1024];
    private double[] share = new double[1024];
    private int count;

    void add(int a, int b, double k, double length, double contractile) {
        if (count == nodeA.length) {
            int more = 2 * count;
            nodeA = Arrays.copyOf(nodeA, more);
            nodeB = Arrays.copyOf(nodeB, more);
            stiffness = Arrays.copyOf(stiffness, more);
            rest = Arrays.copyOf(rest, more);
            share = Arrays.copyOf(share, more);
        }
        nodeA[count] = a;
        nodeB[count] = b;
        stiffness[count] = k;
        rest[count] = length;
        share[count] = contractile;
        count++;
    }

    int count() {
        return count;
    }

    int[] nodeA() {
        return Arrays.copyOf(nodeA, count);
    }

    int[] nodeB() {
        return Arrays.copyOf(nodeB, count);
    }

    double[] stiffness() {
        return Arrays.copyOf(stiffness, count);
    }

    double[] rest() {
        return Arrays.copyOf(rest, count);
    }

    double[] share() {
        return Arrays.copyOf(share, count);
    }

    /** Gives spring i another rest length, mm. */
    void setRest(int i, double length) {
        rest[i] = length;
    }

    boolean anyContractile() {
        for (int i = 0; i < count; i++) {
            if (share[i] != 0) {
                return true;
            }
        }
        return false;
    }
}
