package org.phrenic.engine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.engine.parallel.Workers;

/**
 * Projects separable constraints by islands. Items that share nodes, directly or through others, form an island.
 * Islands are independent, so one thread carries a group of islands through all Gauss-Seidel sweeps without
 * synchronisation. An island in which the first sweep moves nothing is skipped in later sweeps (nine of ten in a quiet
 * breath), and an item that is alone in its island is projected in the first sweep only. The result equals that of
 * sweeping over all constraints one after the other, except for an item alone whose correction is cut short, as that of
 * a sliding contact is by its largest speed: here its node is shifted once a step, there once a sweep.
 */
final class IslandProjection {
    /**
     * Largest island, in nodes. Larger ones would leave threads idle; a pair of sheet nodes with its link and contacts
     * has five.
     */
    private static final int MAX_GROUP_NODES = 64;

    private static final int NODES_A_PIECE = 512;

    private final IslandItems[] members;
    private final int pieces;
    /** For each island, the last projection whose first sweep moved one of its nodes. */
    private final int[] movedIn;

    private final Workers.Task task = this::piece;
    private ParticleSystem system;
    private double step;
    private int sweeps;
    private int round;

    private IslandProjection(List<SeparableConstraint> constraints, ConstraintIslands groups) {
        int[] pieceOfNode = groups.assignPieces(NODES_A_PIECE);
        pieces = groups.pieceCount();
        movedIn = new int[pieceOfNode.length];
        members = constraints.stream()
                .map(each -> new IslandItems(each, groups, pieceOfNode, pieces))
                .toArray(IslandItems[]::new);
    }

    /**
     * A projection of these constraints, in their order; empty if one is not separable or an island is too large.
     *
     * @param nodeCount number of nodes of the system
     */
    static Optional<IslandProjection> of(List<? extends Constraint> constraints, int nodeCount) {
        if (!constraints.stream().allMatch(each -> each instanceof SeparableConstraint s && s.isSeparable())) {
            return Optional.empty();
        }
        List<SeparableConstraint> separable =
                constraints.stream().map(SeparableConstraint.class::cast).toList();
        ConstraintIslands groups = new ConstraintIslands(separable, nodeCount);
        return groups.largestSize() > MAX_GROUP_NODES
                ? Optional.empty()
                : Optional.of(new IslandProjection(separable, groups));
    }

    /** Projects all constraints after a step of length h, in a given number of sweeps. */
    void project(ParticleSystem particles, double h, int sweepCount) {
        system = particles;
        step = h;
        sweeps = sweepCount;
        round++;
        particles.workers().run(pieces, task);
    }

    private void piece(int piece) {
        for (IslandItems member : members) {
            int from = member.start[piece];
            member.moved[piece] = member.constraint.project(
                    system, step, member.items, from, member.start[piece + 1], member.movedItems);
            member.repeatEnd[piece] = from;
        }
        if (sweeps == 1) {
            return;
        }
        for (IslandItems member : members) {
            int from = member.start[piece];
            for (int k = from; k < from + member.moved[piece]; k++) {
                int group = member.islandOfItem[member.movedItems[k]];
                if (group >= 0 && movedIn[group] != round) {
                    movedIn[group] = round;
                    for (IslandItems each : members) {
                        each.scheduleRepeat(group, piece);
                    }
                }
            }
        }
        for (int sweep = 1; sweep < sweeps; sweep++) {
            for (IslandItems member : members) {
                member.constraint.project(
                        system,
                        step,
                        member.repeatItems,
                        member.start[piece],
                        member.repeatEnd[piece],
                        member.movedItems);
            }
        }
    }

    /** A constraint with its items sorted by piece and by island. */
    private static final class IslandItems {
        final SeparableConstraint constraint;
        /** Items sorted by piece, and where each piece begins. */
        final int[] items;

        final int[] start;
        /** For each item, its island; -1 if it is the only one in its island and one sweep is enough. */
        final int[] islandOfItem;
        /** Items sorted by island, and where each island begins. */
        private final int[] itemsByIsland;

        private final int[] islandStart;
        /** For each piece, from its beginning: the items that the sweep moved, and their number. */
        final int[] movedItems;

        final int[] moved;
        /** For each piece, from its beginning: the items of islands that need another sweep, and where they end. */
        final int[] repeatItems;

        final int[] repeatEnd;

        IslandItems(SeparableConstraint constraint, ConstraintIslands groups, int[] pieceOfNode, int pieces) {
            this.constraint = constraint;
            int[] first = constraint.itemNodes()[0];
            int count = first.length;
            items = new int[count];
            islandOfItem = new int[count];
            itemsByIsland = new int[count];
            start = new int[pieces + 1];
            islandStart = new int[pieceOfNode.length + 1];
            long[] byPiece = new long[count];
            long[] together = new long[count];
            for (int i = 0; i < count; i++) {
                int node = first[i] / 3;
                int root = groups.islandOf(node);
                enter(i, root, groups.itemCount(node) > 1, pieceOfNode[node], byPiece, together);
            }
            RadixSort.sort(byPiece);
            RadixSort.sort(together);
            for (int i = 0; i < count; i++) {
                items[i] = (int) byPiece[i];
                itemsByIsland[i] = (int) together[i];
            }
            Arrays.parallelPrefix(start, Integer::sum);
            Arrays.parallelPrefix(islandStart, Integer::sum);
            movedItems = new int[count];
            moved = new int[pieces];
            repeatItems = new int[count];
            repeatEnd = new int[pieces];
        }

        private void enter(int i, int root, boolean hasCompany, int piece, long[] byPiece, long[] together) {
            islandOfItem[i] = hasCompany ? root : -1;
            byPiece[i] = (long) piece << 32 | i;
            together[i] = (long) root << 32 | i;
            start[piece + 1]++;
            islandStart[root + 1]++;
        }

        void scheduleRepeat(int which, int piece) {
            for (int k = islandStart[which]; k < islandStart[which + 1]; k++) {
                repeatItems[repeatEnd[piece]++] = itemsByIsland[k];
            }
        }
    }
}
