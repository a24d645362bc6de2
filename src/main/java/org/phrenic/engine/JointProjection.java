package org.phrenic.engine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.geometry.RadixSort;

/**
 * Separable constraints put right together. Items that share nodes, directly or through others, form a group; groups are independent, so a piece of them goes through all its sweeps at once, while its nodes are
 * in the cache and without waiting for other threads between sweeps. A group in which the first sweep moved nothing holds, and is left out of the others: in a quiet breath that is nine of ten. Which nodes end
 * up where is the same as if all constraints had been gone through in every sweep, one after the other.
 */
final class JointProjection {
    /** A sheet's pair of nodes, its link and its contacts are five; groups beyond this would leave threads idle. */
    private static final int MOST_NODES_A_GROUP = 64;

    private static final int NODES_A_PIECE = 512;

    private final Member[] members;
    private final int pieces;
    /** Of each group: the round in which something of it last moved. */
    private final int[] movedIn;

    private final Workers.Task task = this::piece;
    private ParticleSystem system;
    private double step;
    private int sweeps;
    private int round;

    private JointProjection(List<SeparableConstraint> constraints, ConstraintGroups groups) {
        int[] pieceOfNode = groups.pieces(NODES_A_PIECE);
        pieces = groups.pieceCount();
        movedIn = new int[pieceOfNode.length];
        members = constraints.stream()
                .map(each -> new Member(each, groups, pieceOfNode, pieces))
                .toArray(Member[]::new);
    }

    /**
     * Constraints put right together, in their order; nothing if one is not separable or groups are too large.
     *
     * @param nodeCount of the system
     */
    static Optional<JointProjection> of(List<? extends Constraint> constraints, int nodeCount) {
        if (!constraints.stream().allMatch(each -> each instanceof SeparableConstraint s && s.isSeparable())) {
            return Optional.empty();
        }
        List<SeparableConstraint> separable =
                constraints.stream().map(SeparableConstraint.class::cast).toList();
        ConstraintGroups groups = new ConstraintGroups(separable, nodeCount);
        return groups.largest() > MOST_NODES_A_GROUP
                ? Optional.empty()
                : Optional.of(new JointProjection(separable, groups));
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
        for (Member member : members) {
            int from = member.start[piece];
            member.moved[piece] = member.constraint.project(
                    system, step, member.items, from, member.start[piece + 1], member.movedItems);
            member.againEnd[piece] = from;
        }
        if (sweeps == 1) {
            return;
        }
        for (Member member : members) {
            int from = member.start[piece];
            for (int k = from; k < from + member.moved[piece]; k++) {
                int group = member.group[member.movedItems[k]];
                if (group >= 0 && movedIn[group] != round) {
                    movedIn[group] = round;
                    for (Member each : members) {
                        each.repeat(group, piece);
                    }
                }
            }
        }
        for (int sweep = 1; sweep < sweeps; sweep++) {
            for (Member member : members) {
                member.constraint.project(
                        system, step, member.again, member.start[piece], member.againEnd[piece], member.movedItems);
            }
        }
    }

    /** A constraint, its items by pieces and by groups. */
    private static final class Member {
        final SeparableConstraint constraint;
        /** Items piece after piece, and where pieces begin. */
        final int[] items;

        final int[] start;
        /** Of each item: its group; -1 if it is alone and one sweep is enough. */
        final int[] group;
        /** Items group after group, and where groups begin. */
        private final int[] byGroup;

        private final int[] groupStart;
        /** Of each piece, from where it begins: items that the sweep moved, and how many. */
        final int[] movedItems;

        final int[] moved;
        /** Of each piece, from where it begins: items of the groups that need another sweep, and where they end. */
        final int[] again;

        final int[] againEnd;

        Member(SeparableConstraint constraint, ConstraintGroups groups, int[] pieceOfNode, int pieces) {
            this.constraint = constraint;
            int[] first = constraint.ends()[0];
            int count = first.length;
            items = new int[count];
            group = new int[count];
            byGroup = new int[count];
            start = new int[pieces + 1];
            groupStart = new int[pieceOfNode.length + 1];
            long[] byPiece = new long[count];
            long[] together = new long[count];
            for (int i = 0; i < count; i++) {
                int node = first[i] / 3;
                int root = groups.of(node);
                enter(i, root, groups.itemCount(node) > 1, pieceOfNode[node], byPiece, together);
            }
            RadixSort.sort(byPiece);
            RadixSort.sort(together);
            for (int i = 0; i < count; i++) {
                items[i] = (int) byPiece[i];
                byGroup[i] = (int) together[i];
            }
            Arrays.parallelPrefix(start, Integer::sum);
            Arrays.parallelPrefix(groupStart, Integer::sum);
            movedItems = new int[count];
            moved = new int[pieces];
            again = new int[count];
            againEnd = new int[pieces];
        }

        private void enter(int i, int root, boolean hasCompany, int piece, long[] byPiece, long[] together) {
            group[i] = hasCompany ? root : -1;
            byPiece[i] = (long) piece << 32 | i;
            together[i] = (long) root << 32 | i;
            start[piece + 1]++;
            groupStart[root + 1]++;
        }

        void repeat(int which, int piece) {
            for (int k = groupStart[which]; k < groupStart[which + 1]; k++) {
                again[againEnd[piece]++] = byGroup[k];
            }
        }
    }
}
