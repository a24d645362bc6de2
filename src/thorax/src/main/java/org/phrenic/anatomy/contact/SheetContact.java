package org.phrenic.anatomy.contact;

import java.util.Arrays;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.PointClusters;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Contact of soft organs with the moving diaphragm, for the surfaces that are shown and exported; forces and
 * observables do not change. A vertex beyond the face of its own side yields: it is moved to its nearest point of that
 * face, except for a depth of {@value #ALLOWED_MM} mm. Where the nearest point of the sheet lies on its border there
 * are no sides.
 */
public final class SheetContact {
    private static final double ALLOWED_MM = 2;
    /** Vertices farther beyond the sheet are left alone: the nearest point says nothing about them. */
    private static final double REACH_MM = 40;
    /** Distance up to which the first point of a cluster is searched for. */
    private static final double CLUSTER_REACH_MM = 60;
    /**
     * Where the sheet passes through itself, a point that it has not crossed may lie between its faces: about as near
     * to it as it is thick.
     */
    private static final double FOLD_REACH_MM = 5;
    /** Such a point is searched for up to the height of a pleat: an edge of the coarsest sheet and the thickness. */
    private static final double PLEAT_REACH_MM = 10;
    /** Weight of a corner below which a nearest point lies on the opposite side of its triangle. */
    private static final double ON_SIDE = 1e-9;

    /** A point is searched for this much farther than is needed now, so that it is far enough for some frames. */
    private static final double AHEAD_MM = 6;

    /** Far more than the rounding of a distance. */
    private static final double ROUNDING_MM = 1e-6;

    private final int first;
    private final TriangleTree sheet;
    private final SheetFaces faces;
    private final double[] positions;
    /** Sum of the largest distances that a vertex has moved from update to update, mm. */
    private double travelMm;

    private final double[] normal = new double[3];
    private final MeshTopology topology;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final TriangleTree.Hit onFace = new TriangleTree.Hit();

    /**
     * @param diaphragm the sheet at rest
     * @param firstNode scene node of its first vertex
     */
    public SheetContact(Diaphragm diaphragm, int firstNode) {
        TriangleMesh mesh = diaphragm.sheet();
        first = firstNode;
        positions = mesh.positions().clone();
        sheet = new TriangleTree(mesh);
        topology = new MeshTopology(mesh);
        faces = new SheetFaces(diaphragm, topology);
    }

    /** @param nodes current positions of the whole scene, caller's order */
    public void update(double[] nodes) {
        travelMm += farthestMm(nodes);
        System.arraycopy(nodes, 3 * first, positions, 0, positions.length);
        sheet.refit(positions);
    }

    /** Largest distance from a vertex of the sheet to where it is now. */
    private double farthestMm(double[] nodes) {
        double most = 0;
        for (int i = 0; i < positions.length; i += 3) {
            double dx = nodes[3 * first + i] - positions[i];
            double dy = nodes[3 * first + i + 1] - positions[i + 1];
            double dz = nodes[3 * first + i + 2] - positions[i + 2];
            most = Math.max(most, dx * dx + dy * dy + dz * dz);
        }
        return Math.sqrt(most);
    }

    /**
     * An organ on one side of the sheet. Its points are searched in clusters: no sheet lies between the first of a
     * cluster and a point that is nearer to it than the sheet is. Such a point lies on the same side, and is searched
     * only if a fold of the sheet may be as near to it as {@value #FOLD_REACH_MM} mm.
     *
     * <p>What yields is a function of where the organ and the sheet are. Of earlier frames only what changes no answer
     * is kept: the triangle at which a search begins, and a distance that spares the search of points out of reach.
     * Sides are not: where the sheet passes through itself, points followed from frame to frame would lie on other
     * sides than points searched in one frame alone.
     */
    public final class Organ {
        private final boolean above;
        private final PointClusters clusters;
        /** Nearest triangle of each point when last searched for. */
        private final int[] nearest;
        /** Place of each point when last searched, three numbers. */
        private final double[] searchedAt;
        /** Least distance of each point from the sheet when last searched, plus the sheet's travel until then, mm. */
        private final double[] leastMm;
        /** Search in which each point last lay certainly on the organ's side, and its distance from the sheet there. */
        private final int[] onSideIn;

        private final double[] onSideMm;
        /** Search in which each point was last found not to lie beyond, and up to which distance from it. */
        private final int[] searchedIn;

        private final double[] searchedMm;
        /** Number of searches of this organ that were begun. */
        private int search;
        /** Whether the point that was last searched lay beyond the face of the organ's side. */
        private boolean beyond;

        private Organ(double[] rest, boolean above) {
            this.above = above;
            clusters = new PointClusters(rest);
            nearest = new int[rest.length / 3];
            searchedAt = rest.clone();
            leastMm = new double[nearest.length];
            onSideIn = new int[nearest.length];
            onSideMm = new double[nearest.length];
            searchedIn = new int[nearest.length];
            searchedMm = new double[nearest.length];
            Arrays.fill(nearest, -1);
            Arrays.fill(leastMm, Double.NEGATIVE_INFINITY);
        }

        /** Moves the points that lie beyond the face of the organ's side; three numbers a point, changed in place. */
        public void pushBack(double[] points) {
            search++;
            pushBackAgain(points);
        }

        /**
         * As {@link #pushBack}, for points that were moved since then, while the sheet stands still: one that lay on
         * its side, and has moved by less than it was away from the sheet, less {@value #FOLD_REACH_MM} mm, still does
         * and is not searched again, nor is one that has not moved.
         */
        public void pushBackAgain(double[] points) {
            int[] order = clusters.order();
            for (int c = 0; c < clusters.count(); c++) {
                int k = 3 * order[clusters.start(c)];
                if (isBeyondReach(points, k, REACH_MM + radius(points, c))) {
                    continue;
                }
                double x = points[k];
                double y = points[k + 1];
                double z = points[k + 2];
                double free = freeDistance(points, k);
                for (int i = clusters.start(c) + 1; i < clusters.start(c + 1); i++) {
                    int m = 3 * order[i];
                    double dx = points[m] - x;
                    double dy = points[m + 1] - y;
                    double dz = points[m + 2] - z;
                    double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
                    double reach = distance < free ? PLEAT_REACH_MM : REACH_MM;
                    if (distance + FOLD_REACH_MM > free
                            && !isStillOnSide(points, m)
                            && !isSearched(points, m, reach)
                            && !isAtFace(points, m)) {
                        pushBack(points, m, reach);
                    }
                }
            }
        }

        /** Largest distance of a point of a cluster from its first one, mm. */
        private double radius(double[] points, int cluster) {
            int[] order = clusters.order();
            int k = 3 * order[clusters.start(cluster)];
            double most = 0;
            for (int i = clusters.start(cluster) + 1; i < clusters.start(cluster + 1); i++) {
                most = Math.max(most, squaredDistance(points, 3 * order[i], points, k));
            }
            return Math.sqrt(most);
        }

        /**
         * Whether a point is certainly farther from the sheet than a distance, by where both were when last searched.
         */
        private boolean isBeyondReach(double[] points, int k, double mm) {
            double free = leastMm[k / 3] - travelMm - mm - ROUNDING_MM;
            return free > 0 && squaredDistance(points, k, searchedAt, k) < free * free;
        }

        /** Whether a point cannot have crossed the sheet, nor come near to a fold of it, since this search began. */
        private boolean isStillOnSide(double[] points, int k) {
            double free = onSideMm[k / 3] - FOLD_REACH_MM - ROUNDING_MM;
            return onSideIn[k / 3] == search && free > 0 && squaredDistance(points, k, searchedAt, k) < free * free;
        }

        /** Whether a point that has not been moved since was found not to lie beyond in this search, as far as this. */
        private boolean isSearched(double[] points, int k, double reachMm) {
            return searchedIn[k / 3] == search
                    && searchedMm[k / 3] >= reachMm
                    && squaredDistance(points, k, searchedAt, k) == 0;
        }

        /**
         * Whether a point lies so near to a triangle of its own face that it is not moved even if it is beyond; tells
         * of no point that it is farther.
         */
        private boolean isAtFace(double[] points, int k) {
            int triangle = nearest[k / 3];
            return triangle >= 0
                    && faces.face(above)[triangle]
                    && sheet.squaredDistance(triangle, points[k], points[k + 1], points[k + 2], hit)
                            <= ALLOWED_MM * ALLOWED_MM;
        }

        /** Moves a point if it lies beyond; returns up to which distance all points lie on the organ's side, mm. */
        private double freeDistance(double[] points, int k) {
            if (isStillOnSide(points, k)) {
                return onSideMm[k / 3] - Math.sqrt(squaredDistance(points, k, searchedAt, k));
            }
            if (!pushBack(points, k, CLUSTER_REACH_MM)) {
                return CLUSTER_REACH_MM;
            }
            return beyond || faces.isOnBorder(hit) ? 0 : Math.sqrt(hit.distanceSquared);
        }

        /** Moves a point if it lies beyond; returns whether the sheet is within a distance, of which the hit tells. */
        private boolean pushBack(double[] points, int k, double reachMm) {
            if (isBeyondReach(points, k, reachMm)) {
                beyond = false;
                return false;
            }
            double x = points[k];
            double y = points[k + 1];
            double z = points[k + 2];
            boolean found = sheet.closest(x, y, z, reachMm + AHEAD_MM, nearest[k / 3], null, hit);
            boolean near = found && hit.distanceSquared <= reachMm * reachMm;
            nearest[k / 3] = hit.triangle;
            System.arraycopy(points, k, searchedAt, k, 3);
            leastMm[k / 3] = travelMm + (found ? Math.sqrt(hit.distanceSquared) : reachMm + AHEAD_MM);
            beyond = near && isBeyond(points, k, above);
            searchedIn[k / 3] = beyond ? 0 : search;
            searchedMm[k / 3] = reachMm;
            boolean inReach = near && hit.distanceSquared <= REACH_MM * REACH_MM;
            onSideIn[k / 3] = inReach && !beyond && !faces.isOnBorder(hit) ? search : 0;
            onSideMm[k / 3] = Math.sqrt(hit.distanceSquared);
            if (beyond && inReach && sheet.closest(x, y, z, REACH_MM, -1, faces.face(above), onFace)) {
                yieldTo(points, k);
            }
            return near;
        }
    }

    /**
     * An organ that yields to the sheet.
     *
     * @param rest points at rest, three numbers each
     * @param above whether the organ lies above the thoracic face; else below the abdominal face
     */
    public Organ organ(double[] rest, boolean above) {
        return new Organ(rest, above);
    }

    private static double squaredDistance(double[] points, int k, double[] others, int m) {
        double dx = points[k] - others[m];
        double dy = points[k + 1] - others[m + 1];
        double dz = points[k + 2] - others[m + 2];
        return dx * dx + dy * dy + dz * dz;
    }

    private void yieldTo(double[] points, int k) {
        if (onFace.distanceSquared > ALLOWED_MM * ALLOWED_MM) {
            double share = 1 - ALLOWED_MM / Math.sqrt(onFace.distanceSquared);
            points[k] += share * (onFace.x - points[k]);
            points[k + 1] += share * (onFace.y - points[k + 1]);
            points[k + 2] += share * (onFace.z - points[k + 2]);
        }
    }

    /**
     * Whether the last nearest point of the sheet is within the other face, or the point is between the faces: as near
     * to its own as the sheet is thick, and inside. Where the sheet passes through itself, the normal at the nearest
     * point says nothing of a point farther away.
     */
    private boolean isBeyond(double[] points, int k, boolean above) {
        if (faces.isOnBorder(hit)) {
            return false;
        }
        return !faces.face(above)[hit.triangle]
                || (hit.distanceSquared <= FOLD_REACH_MM * FOLD_REACH_MM && outside(points, k) < 0);
    }

    /** Positive outside the sheet, by the normal of the face, edge or vertex on which the last nearest point lies. */
    private double outside(double[] points, int k) {
        boolean a = hit.weightA > ON_SIDE;
        boolean b = hit.weightB > ON_SIDE;
        boolean c = hit.weightC > ON_SIDE;
        boolean atCorner = a ? !b && !c : b != c;
        if (atCorner) {
            return alongVertex(sheet.mesh().triangles()[3 * hit.triangle + (a ? 0 : b ? 1 : 2)], points, k);
        }
        double out = alongTriangle(hit.triangle, points, k);
        if (a && b && c) {
            return out;
        }
        int edge = topology.edgeOfSide()[3 * hit.triangle + (!c ? 0 : !a ? 1 : 2)];
        int other = edge == MeshTopology.NONE ? edge : topology.otherFace(edge, hit.triangle);
        return other == MeshTopology.NONE ? out : out + alongTriangle(other, points, k);
    }

    /** Component along the sum of the area vectors of the triangles about a vertex. */
    private double alongVertex(int v, double[] points, int k) {
        int[] t = sheet.mesh().triangles();
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = topology.vertexTriangleStart()[v]; i < topology.vertexTriangleStart()[v + 1]; i++) {
            int corner = 3 * topology.vertexTriangles()[i];
            Triangles.cross(positions, 3 * t[corner], 3 * t[corner + 1], 3 * t[corner + 2], normal);
            x += normal[0];
            y += normal[1];
            z += normal[2];
        }
        normal[0] = x;
        normal[1] = y;
        normal[2] = z;
        return along(points, k);
    }

    /** Component along the unit normal of a triangle. */
    private double alongTriangle(int triangle, double[] points, int k) {
        int[] t = sheet.mesh().triangles();
        int corner = 3 * triangle;
        Triangles.cross(positions, 3 * t[corner], 3 * t[corner + 1], 3 * t[corner + 2], normal);
        double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        return along(points, k) / Math.max(length, Double.MIN_NORMAL);
    }

    private double along(double[] points, int k) {
        return normal[0] * (points[k] - hit.x)
                + normal[1] * (points[k + 1] - hit.y)
                + normal[2] * (points[k + 2] - hit.z);
    }
}
