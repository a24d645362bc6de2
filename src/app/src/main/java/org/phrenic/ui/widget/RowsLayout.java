package org.phrenic.ui.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.Box;

/**
 * Components beside each other, in as many rows as the width of their container takes. A glue ({@link Box.Filler})
 * takes what is left of its row. The container asks for another height once it has another width.
 */
public final class RowsLayout implements LayoutManager {
    private final int gap;

    /** @param gap between rows, pixels */
    public RowsLayout(int gap) {
        this.gap = gap;
    }

    private static List<Component> shown(Container parent) {
        return Stream.of(parent.getComponents()).filter(Component::isVisible).toList();
    }

    private static boolean isGlue(Component part) {
        return part instanceof Box.Filler && part.getMaximumSize().width > part.getPreferredSize().width;
    }

    private static int width(List<Component> row) {
        return row.stream().mapToInt(part -> part.getPreferredSize().width).sum();
    }

    private static int height(List<Component> row) {
        return row.stream()
                .mapToInt(part -> part.getPreferredSize().height)
                .max()
                .orElse(0);
    }

    private static List<List<Component>> rows(Container parent, int room) {
        List<List<Component>> rows = new ArrayList<>();
        List<Component> row = new ArrayList<>();
        int used = 0;
        for (Component part : shown(parent)) {
            int wide = part.getPreferredSize().width;
            if (!row.isEmpty() && used + wide > room) {
                rows.add(row);
                row = new ArrayList<>();
                used = 0;
            }
            row.add(part);
            used += wide;
        }
        rows.add(row);
        return rows;
    }

    /** The size in one row as long as there is no width, then in the rows that the width takes. */
    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Insets insets = parent.getInsets();
        int around = insets.left + insets.right;
        int room = parent.getWidth() > 0 ? parent.getWidth() - around : Integer.MAX_VALUE;
        List<List<Component>> rows = rows(parent, room);
        int height = rows.stream().mapToInt(RowsLayout::height).sum() + (rows.size() - 1) * gap;
        return new Dimension(width(shown(parent)) + around, height + insets.top + insets.bottom);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return preferredLayoutSize(parent);
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = parent.getInsets();
        int room = parent.getWidth() - insets.left - insets.right;
        int y = insets.top;
        for (List<Component> row : rows(parent, room)) {
            int height = height(row);
            int free = Math.max(0, room - width(row));
            int x = insets.left;
            for (Component part : row) {
                Dimension size = part.getPreferredSize();
                int wide = size.width + (isGlue(part) ? free : 0);
                part.setBounds(x, y + (height - size.height) / 2, wide, size.height);
                x += wide;
            }
            y += height + gap;
        }
    }

    @Override
    public void addLayoutComponent(String name, Component part) {}

    @Override
    public void removeLayoutComponent(Component part) {}
}
