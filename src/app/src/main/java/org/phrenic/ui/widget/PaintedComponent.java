package org.phrenic.ui.widget;

import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A component that paints itself, with an accessible role and name. */
public abstract class PaintedComponent extends JComponent {
    private final transient AccessibleRole role;

    protected PaintedComponent(AccessibleRole role, String name) {
        this.role = role;
        getAccessibleContext().setAccessibleName(name);
    }

    @Override
    public final AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return role;
                }
            };
        }
        return accessibleContext;
    }

    @Override
    protected final void paintComponent(Graphics graphics) {
        Graphics2D g = Controls.smooth(graphics);
        g.setFont(getFont());
        paintContent(g);
        g.dispose();
    }

    /** Paints with smooth lines and letters in the component's font. */
    protected abstract void paintContent(Graphics2D g);
}
