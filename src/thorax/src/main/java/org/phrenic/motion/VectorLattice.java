package org.phrenic.motion;

import java.util.Arrays;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * Vectors at the nodes of a regular lattice of cubes that is parallel to the axes, with trilinear interpolation between
 * them. Beyond the lattice the vector of its nearest place holds. Node (i, j, k) has the index {@code i + nx (j + ny
 * k)}.
 */
final class VectorLattice implements RegionField {
    /** Offsets of the six neighbours along each axis. */
    private static final int NEIGHBOURS = 6;

    final double edge;
    final double[] low;
    final int[] size;
    final double[] vectors;

    /**
     * @param low place of node (0, 0, 0), mm
     * @param edge distance of two nodes, mm
     */
    VectorLattice(double[] low, int[] size, double edge) {
        this.low = low.clone();
        this.size = size.clone();
        this.edge = edge;
        vectors = new double[3 * size[0] * size[1] * size[2]];
    }

    /** A lattice that covers a box (three least, three greatest coordinates) and a margin about it. */
    static VectorLattice covering(double[] box, double margin, double edge) {
        double[] low = new double[3];
        int[] size = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = edge * Math.floor((box[axis] - margin) / edge);
            size[axis] = 2 + (int) Math.floor((box[3 + axis] + margin - low[axis]) / edge);
        }
        return new VectorLattice(low, size, edge);
    }

    int nodes() {
        return size[0] * size[1] * size[2];
    }

    /** Coordinate of a node along an axis, mm. */
    double place(int node, int axis) {
        int at = axis == 0 ? node % size[0] : axis == 1 ? node / size[0] % size[1] : node / size[0] / size[1];
        return low[axis] + edge * at;
    }

    /** The nodes as voxels. */
    VoxelBox box() {
        return new VoxelBox(size, new double[] {edge, 0, 0, low[0], 0, edge, 0, low[1], 0, 0, edge, low[2]});
    }

    /** The first node of the cell that holds a place; writes the place within it, 0 to 1 along each axis. */
    int cell(double x, double y, double z, double[] within) {
        int i = along(0, x, within);
        int j = along(1, y, within);
        int k = along(2, z, within);
        return i + size[0] * (j + size[1] * k);
    }

    private int along(int axis, double value, double[] within) {
        double place = Math.max(0, Math.min(size[axis] - 1, (value - low[axis]) / edge));
        int cell = Math.min(size[axis] - 2, (int) place);
        within[axis] = place - cell;
        return cell;
    }

    /** Node of a corner of a cell, 0 to 7: the bits of the corner are steps along x, y and z. */
    int corner(int cell, int corner) {
        return cell + (corner & 1) + size[0] * ((corner >> 1 & 1) + size[1] * (corner >> 2));
    }

    /** Trilinear weight of a corner. */
    static double weight(double[] within, int corner) {
        return ((corner & 1) == 1 ? within[0] : 1 - within[0])
                * ((corner >> 1 & 1) == 1 ? within[1] : 1 - within[1])
                * (corner >> 2 == 1 ? within[2] : 1 - within[2]);
    }

    @Override
    public void at(double x, double y, double z, double[] out) {
        // The place within the cell is kept in the result until the end, so that nothing is allocated.
        int a = 3 * cell(x, y, z, out);
        double u = out[0];
        double v = out[1];
        double w = out[2];
        int b = a + 3 * size[0];
        int c = a + 3 * size[0] * size[1];
        int d = c + 3 * size[0];
        for (int axis = 0; axis < 3; axis++, a++, b++, c++, d++) {
            double near = mix(mix(vectors[a], vectors[a + 3], u), mix(vectors[b], vectors[b + 3], u), v);
            double far = mix(mix(vectors[c], vectors[c + 3], u), mix(vectors[d], vectors[d + 3], u), v);
            out[axis] = mix(near, far, w);
        }
    }

    private static double mix(double a, double b, double share) {
        return a + share * (b - a);
    }

    /** A node's neighbour, 0 to 5; -1 at the border. */
    int neighbour(int node, int which) {
        int axis = which / 2;
        int stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
        int at = node / stride % size[axis];
        if (which % 2 == 0) {
            return at > 0 ? node - stride : -1;
        }
        return at < size[axis] - 1 ? node + stride : -1;
    }

    /** The marked nodes and their 26 neighbours. */
    boolean[] dilated(boolean[] marked) {
        boolean[] wide = marked;
        for (int axis = 0; axis < 3; axis++) {
            boolean[] from = wide;
            wide = from.clone();
            for (int node = 0; node < from.length; node++) {
                for (int side = 0; side < 2 && from[node]; side++) {
                    int next = neighbour(node, 2 * axis + side);
                    if (next >= 0) {
                        wide[next] = true;
                    }
                }
            }
        }
        return wide;
    }

    /** The way in which vectors go on beyond the nodes that have one; found once for a lattice. */
    static final class Extension {
        private final int[] order;
        private final int[] parents;
        private final double[] fade;

        /**
         * @param known nodes that have a vector
         * @param kept number of layers of nodes about them that take the mean of the layer before
         * @param faded number of further layers over which the vectors fade to 0; none: they never fade
         */
        Extension(VectorLattice lattice, boolean[] known, int kept, int faded) {
            int[] layer = new int[known.length];
            IntList queue = new IntList();
            for (int node = 0; node < known.length; node++) {
                layer[node] = known[node] ? 0 : -1;
                if (known[node]) {
                    queue.add(node);
                }
            }
            int first = queue.size();
            for (int at = 0; at < queue.size(); at++) {
                for (int side = 0; side < NEIGHBOURS; side++) {
                    int next = lattice.neighbour(queue.get(at), side);
                    if (next >= 0 && layer[next] < 0) {
                        layer[next] = layer[queue.get(at)] + 1;
                        queue.add(next);
                    }
                }
            }
            order = Arrays.copyOfRange(queue.toArray(), first, queue.size());
            parents = new int[NEIGHBOURS * order.length];
            fade = new double[order.length];
            for (int n = 0; n < order.length; n++) {
                int own = layer[order[n]];
                for (int side = 0; side < NEIGHBOURS; side++) {
                    int other = lattice.neighbour(order[n], side);
                    parents[NEIGHBOURS * n + side] = other >= 0 && layer[other] == own - 1 ? other : -1;
                }
                // Each layer takes from the one before, so that the factors multiply to a line that falls to 0.
                double left = 1 - Math.max(0, own - kept) / (faded + 1.0);
                double before = 1 - Math.max(0, own - 1 - kept) / (faded + 1.0);
                fade[n] = faded == 0 ? 1 : left > 0 ? left / before : 0;
            }
        }

        void apply(double[] vectors) {
            for (int n = 0; n < order.length; n++) {
                double x = 0;
                double y = 0;
                double z = 0;
                int count = 0;
                for (int side = 0; side < NEIGHBOURS; side++) {
                    int parent = 3 * parents[NEIGHBOURS * n + side];
                    if (parent >= 0) {
                        x += vectors[parent];
                        y += vectors[parent + 1];
                        z += vectors[parent + 2];
                        count++;
                    }
                }
                vectors[3 * order[n]] = fade[n] * x / count;
                vectors[3 * order[n] + 1] = fade[n] * y / count;
                vectors[3 * order[n] + 2] = fade[n] * z / count;
            }
        }
    }
}
