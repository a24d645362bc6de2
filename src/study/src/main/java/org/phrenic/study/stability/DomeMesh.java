package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Closed dome-shaped sheet of the synthetic stability cases: two triangulated faces, 60 mm high and 200 mm wide, joined
 * at the rim and up to 4 mm apart.
 *
 * @param positions three coordinates per node, mm: the upper face, then the lower one without its rim
 * @param triangles three nodes per triangle, oriented outward
 * @param below node of the lower face below each node of the upper face; the node itself on the rim
 * @param rim nodes shared by the two faces
 */
record DomeMesh(double[] positions, int[] triangles, int[] below, int[] rim) {
    private static final double RADIUS = 100;
    private static final double HEIGHT = 60;
    private static final double THICKNESS = 4;

    /** Equilateral triangles in plan, valence 6, in {@code rings} hexagonal rings around the top. */
    static DomeMesh regular(int rings) {
        int side = 2 * rings + 1;
        int[] number = new int[side * side];
        Arrays.fill(number, -1);
        List<double[]> plan = new ArrayList<>();
        List<Integer> rim = new ArrayList<>();
        double spacing = RADIUS / rings;
        for (int r = -rings; r <= rings; r++) {
            for (int q = Math.max(-rings, -r - rings); q <= Math.min(rings, -r + rings); q++) {
                number[(r + rings) * side + q + rings] = plan.size();
                if (Math.max(Math.abs(q), Math.max(Math.abs(r), Math.abs(q + r))) == rings) {
                    rim.add(plan.size());
                }
                plan.add(new double[] {spacing * (q + 0.5 * r), spacing * r * Math.sqrt(0.75)});
            }
        }
        List<int[]> faces = new ArrayList<>();
        for (int r = 0; r < side - 1; r++) {
            for (int q = 0; q < side; q++) {
                int a = number[r * side + q];
                int c = number[(r + 1) * side + q];
                if (q + 1 < side && a >= 0 && number[r * side + q + 1] >= 0 && c >= 0) {
                    faces.add(new int[] {a, number[r * side + q + 1], c});
                }
                if (q > 0 && a >= 0 && c >= 0 && number[(r + 1) * side + q - 1] >= 0) {
                    faces.add(new int[] {a, c, number[(r + 1) * side + q - 1]});
                }
            }
        }
        return closed(plan, faces, rim);
    }

    /**
     * Irregular mesh: a node of valence {@code sectors} at the top, and a node of valence 3 in the middle of every
     * second triangle of the outer rings.
     */
    static DomeMesh uneven(int rings, int sectors) {
        List<double[]> plan = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        List<Integer> rim = new ArrayList<>();
        plan.add(new double[] {0, 0});
        for (int r = 1; r <= rings; r++) {
            for (int s = 0; s < sectors; s++) {
                double angle = 2 * Math.PI * (s + 0.5 * r) / sectors;
                double radius = RADIUS * (2 + r) / (2 + rings);
                if (r == rings) {
                    rim.add(plan.size());
                }
                plan.add(new double[] {radius * StrictMath.cos(angle), radius * StrictMath.sin(angle)});
            }
        }
        for (int s = 0; s < sectors; s++) {
            faces.add(new int[] {0, 1 + s, 1 + (s + 1) % sectors});
        }
        for (int r = 1; r < rings; r++) {
            for (int s = 0; s < sectors; s++) {
                int a = 1 + (r - 1) * sectors + s;
                int b = 1 + (r - 1) * sectors + (s + 1) % sectors;
                int c = 1 + r * sectors + s;
                int d = 1 + r * sectors + (s + sectors - 1) % sectors;
                faces.add(new int[] {a, c, b});
                faces.add(new int[] {a, d, c});
            }
        }
        for (int f = faces.size() - 1; f >= sectors; f -= 2) {
            int[] t = faces.get(f);
            int middle = plan.size();
            plan.add(new double[] {
                (plan.get(t[0])[0] + plan.get(t[1])[0] + plan.get(t[2])[0]) / 3,
                (plan.get(t[0])[1] + plan.get(t[1])[1] + plan.get(t[2])[1]) / 3
            });
            faces.set(f, new int[] {t[0], t[1], middle});
            faces.add(new int[] {t[1], t[2], middle});
            faces.add(new int[] {t[2], t[0], middle});
        }
        return closed(plan, faces, rim);
    }

    /**
     * The regular mesh with some nodes moved onto opposite edges. The triangles become 1,000 times as long as high, or
     * degenerate with zero area.
     *
     * @param coincident whether some nodes also coincide with neighbours, so that edges have zero length
     */
    static DomeMesh slivers(int rings, boolean coincident) {
        DomeMesh mesh = regular(rings);
        double[] p = mesh.positions.clone();
        int[] t = mesh.triangles;
        boolean[] held = new boolean[p.length / 3];
        for (int node : mesh.rim) {
            held[node] = true;
        }
        int made = 0;
        for (int f = 0; f < t.length && made < 24; f += 3) {
            int a = t[f];
            int b = t[f + 1];
            int c = t[f + 2];
            if (held[a] || held[b] || held[c]) {
                continue;
            }
            // Near the midpoint of the opposite edge (1/1000 of the distance), on the midpoint, or on an end of the
            // edge.
            double off = made % 3 == 0 ? 1e-3 : 0;
            boolean end = coincident && made % 12 == 5;
            for (int axis = 0; axis < 3; axis++) {
                double middle = end ? p[3 * b + axis] : 0.5 * (p[3 * b + axis] + p[3 * c + axis]);
                p[3 * a + axis] = middle + off * (p[3 * a + axis] - middle);
            }
            held[a] = true;
            held[b] = true;
            held[c] = true;
            made++;
        }
        return new DomeMesh(p, t, mesh.below, mesh.rim);
    }

    /** The regular mesh without the triangles of a ring half way out: an inner and an outer sheet, not connected. */
    static DomeMesh disconnected(int rings) {
        DomeMesh mesh = regular(rings);
        double[] p = mesh.positions;
        int[] kept = IntStream.range(0, mesh.triangles.length / 3)
                .filter(f -> !crosses(p, mesh.triangles, f, 0.55 * RADIUS))
                .flatMap(f -> IntStream.range(3 * f, 3 * f + 3))
                .map(c -> mesh.triangles[c])
                .toArray();
        return new DomeMesh(p, kept, mesh.below, mesh.rim);
    }

    /** Whether a triangle has corners on both sides of a radius in plan. */
    private static boolean crosses(double[] p, int[] triangles, int face, double radius) {
        int inside = 0;
        for (int c = 3 * face; c < 3 * face + 3; c++) {
            inside += StrictMath.hypot(p[3 * triangles[c]], p[3 * triangles[c] + 1]) < radius ? 1 : 0;
        }
        return inside == 1 || inside == 2;
    }

    /** The regular mesh with every seventh triangle turned over. */
    static DomeMesh inverted(int rings) {
        DomeMesh mesh = regular(rings);
        int[] t = mesh.triangles.clone();
        for (int corner = 0; corner < t.length; corner += 21) {
            int first = t[corner];
            t[corner] = t[corner + 1];
            t[corner + 1] = first;
        }
        return new DomeMesh(mesh.positions, t, mesh.below, mesh.rim);
    }

    /** The regular mesh with a fin on every tenth triangle: two more triangles on one of its edges, four in all. */
    static DomeMesh nonManifold(int rings) {
        DomeMesh mesh = regular(rings);
        int[] t = mesh.triangles;
        int fins = t.length / 30;
        int nodes = mesh.positions.length / 3;
        int[] triangles = Arrays.copyOf(t, t.length + 6 * fins);
        double[] p = Arrays.copyOf(mesh.positions, 3 * (nodes + 2 * fins));
        for (int fin = 0; fin < fins; fin++) {
            int corner = 30 * fin;
            for (int side = 0; side < 2; side++) {
                int tip = nodes + 2 * fin + side;
                for (int axis = 0; axis < 3; axis++) {
                    p[3 * tip + axis] = mesh.positions[3 * t[corner + 2] + axis];
                }
                p[3 * tip + 2] += side == 0 ? RADIUS / rings : -RADIUS / rings;
                int at = t.length + 6 * fin + 3 * side;
                triangles[at] = t[corner];
                triangles[at + 1] = t[corner + 1];
                triangles[at + 2] = tip;
            }
        }
        return new DomeMesh(p, triangles, mesh.below, mesh.rim);
    }

    private static DomeMesh closed(List<double[]> plan, List<int[]> faces, List<Integer> rim) {
        int n = plan.size();
        int[] below = new int[n];
        int next = n;
        for (int i = 0; i < n; i++) {
            below[i] = rim.contains(i) ? i : next++;
        }
        double[] p = new double[3 * next];
        for (int i = 0; i < n; i++) {
            double x = plan.get(i)[0];
            double y = plan.get(i)[1];
            double out = Math.min(1, Math.sqrt(x * x + y * y) / RADIUS);
            double z = HEIGHT * (1 - out * out);
            double thick = THICKNESS * Math.sqrt(1 - out * out);
            place(p, below[i], x, y, z - thick);
            place(p, i, x, y, z);
        }
        int[] triangles = new int[6 * faces.size()];
        for (int f = 0; f < faces.size(); f++) {
            int[] t = faces.get(f);
            for (int c = 0; c < 3; c++) {
                triangles[3 * f + c] = t[c];
                triangles[3 * (faces.size() + f) + c] = below[t[2 - c]];
            }
        }
        return new DomeMesh(
                p, triangles, below, rim.stream().mapToInt(Integer::intValue).toArray());
    }

    private static void place(double[] p, int node, double x, double y, double z) {
        p[3 * node] = x;
        p[3 * node + 1] = y;
        p[3 * node + 2] = z;
    }
}
