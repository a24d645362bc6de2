package org.phrenic.engine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.engine.parallel.Workers;

/**
 * Projects separable constraints by islands. Items that share nodes, directly or through others, form an island.
 * Islands are independent, so one thread takes a piece of them through all Gauss-Seidel sweeps without waiting for the
 * others. An island in which the first sweep moved nothing is skipped in later sweeps (nine of ten in a quiet breath).
 * The result is that of sweeping over all constraints one after the other.
 */
final class IslandProjection {
    /** A sheet's pair of nodes, its link and its contacts are five; groups beyond this would leave threads idle. */
    private static final int MOST_NODES_A_GROUP = 64;

    private static final int NODES_A_PIECE = 512;

    private final IslandItems[] members;
    private final int pieces;
    /** Of each group: the round in which something of it last moved. */
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
     * Constraints put right together, in their order; nothing if one is not separable or groups are too large.
     *
     * @param nodeCount of the system
     */
    static Optional<IslandProjection> of(List<? extends Constraint> constraints, int nodeCount) {
        if (!constraints.stream().allMatch(each -> each instanceof SeparableConstraint s && s.isSeparable())) {
            return Optional.empty();
        }
        List<SeparableConstraint> separable =
                constraints.stream().map(SeparableConstraint.class::cast).toList();
        ConstraintIslands groups = new ConstraintIslands(separable, nodeCount);
        return groups.largestSize() > MOST_NODES_A_GROUP
                ? Optional.empty()
                : Optional.of(new IslandProjection(separable, groups));
    }

    /** Puts all right after a step of length h, in so many sweeps. */
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

    /** A constraint, its items by pieces and by groups. */
    private static final class IslandItems {
        final SeparableConstraint constraint;
        /** Items piece after piece, and where pieces begin. */
        final int[] items;

        final int[] start;
        /** Of each item: its group; -1 if it is alone and one sweep is enough. */
        final int[] islandOfItem;
        /** Items group after group, and where groups begin. */
        private final int[] itemsByIsland;

        private final int[] islandStart;
        /** Of each piece, from where it begins: items that the sweep moved, and how many. */
        final int[] movedItems;

        final int[] moved;
        /** Of each piece, from where it begins: items of the groups that need another sweep, and where they end. */
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
