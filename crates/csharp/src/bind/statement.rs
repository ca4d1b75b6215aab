//! Statements.

use super::{Binder, Entry, Item, Jump, Returns, make};
use crate::bound::{Catch, Expr, Kind, Label, Stmt, StmtKind};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::{self, ExprKind, Passing, StmtKind as Written, TypeRefKind, Variable};

impl Binder<'_> {
    pub(super) fn block(&mut self, block: &ast::Block) -> Stmt {
        let (stmts, locals) = self.in_scope(|b| b.statements(&block.stmts));
        Stmt { pos: block.pos, kind: StmtKind::Block(locals, stmts) }
    }

    pub(super) fn statements(&mut self, list: &[ast::Stmt]) -> Vec<Stmt> {
        let functions: Vec<_> = list
            .iter()
            .filter_map(|s| if let Written::Function(f) = &s.kind { Some((s.pos, f.clone())) } else { None })
            .map(|(pos, f)| (pos, self.declare_function(&f), f))
            .collect();
        let body = self.plain_statements(list);
        // Functions may be called before they stand, and see all variables of the block.
        let mut made = Vec::new();
        for (pos, function, written) in functions {
            if let Some(function) = function {
                made.push(self.local_function(pos, &function, &written));
            }
        }
        made.extend(body);
        made
    }

    fn plain_statements(&mut self, list: &[ast::Stmt]) -> Vec<Stmt> {
        let mut made = Vec::new();
        for (i, stmt) in list.iter().enumerate() {
            if let Written::Local { ty, variables, using: true, .. } = &stmt.kind {
                // `using var x = ...;` goes to the end of the block.
                let held = ast::Stmt {
                    pos: stmt.pos,
                    kind: Written::Local {
                        ty: ty.clone(),
                        variables: variables.clone(),
                        constant: false,
                        using: false,
                    },
                };
                let rest: Vec<ast::Stmt> = list[i + 1..].to_vec();
                let block = ast::Block { pos: stmt.pos, end: stmt.pos, stmts: rest };
                let body = ast::Stmt { pos: stmt.pos, kind: Written::Block(block) };
                let kind = self.using(stmt.pos, &held, &body);
                made.push(Stmt { pos: stmt.pos, kind });
                return made;
            }
            made.push(self.statement(stmt));
        }
        made
    }

    pub(super) fn expression_stmt(&self, pos: Pos, value: Expr) -> Stmt {
        Stmt { pos, kind: StmtKind::Expr(value) }
    }

    pub(super) fn statement(&mut self, stmt: &ast::Stmt) -> Stmt {
        let pos = stmt.pos;
        self.nesting += 3;
        let kind = if self.nesting > super::MAX_NESTING {
            self.fault(pos, 8078, "An expression is too long or complex to compile");
            StmtKind::Several(Vec::new())
        } else {
            self.statement_kind(pos, stmt)
        };
        self.nesting -= 3;
        Stmt { pos, kind }
    }

    fn statement_kind(&mut self, pos: Pos, stmt: &ast::Stmt) -> StmtKind {
        match &stmt.kind {
            Written::Empty | Written::Function(_) => StmtKind::Several(Vec::new()),
            Written::Block(block) => self.block(block).kind,
            Written::Local { ty, variables, constant, .. } => self.local_variables(ty, variables, *constant),
            Written::Reference(ty, variables, fixed) => self.references(ty.as_ref(), variables, *fixed),
            Written::Expr(e) => {
                let value = self.value(e);
                StmtKind::Expr(value)
            }
            Written::If(c, yes, no) => {
                let condition = self.condition(c);
                let yes = self.inner(yes);
                let no = no.as_ref().map(|no| Box::new(self.inner(no)));
                StmtKind::If(condition, Box::new(yes), no)
            }
            Written::While(c, body) => {
                let (kind, locals) = self.in_scope(|b| {
                    let condition = b.condition(c);
                    let (body, brk, cont) = b.loop_body(body);
                    StmtKind::Loop(Some(condition), Box::new(body), Vec::new(), brk, cont)
                });
                StmtKind::Block(locals, vec![Stmt { pos, kind }])
            }
            Written::Do(body, c) => {
                let (body, brk, cont) = self.loop_body(body);
                let condition = self.condition(c);
                StmtKind::DoLoop(Box::new(body), condition, brk, cont)
            }
            Written::For(first, c, step, body) => self.for_loop(pos, first, c.as_ref(), step, body),
            Written::Foreach(ty, names, source, body) => self.foreach(pos, ty, names, source, body),
            Written::Switch(subject, sections) => self.switch(pos, subject, sections).kind,
            Written::Break | Written::Continue => self.jump(pos, matches!(stmt.kind, Written::Break)),
            Written::Return(value) => self.return_statement(pos, value.as_ref()),
            Written::Throw(value) => {
                let exception = self.sema.known.exception;
                let value = value.as_ref().map(|e| self.thrown(e, exception));
                StmtKind::Throw(value)
            }
            Written::Try(body, catches, finally) => self.try_statement(body, catches, finally.as_ref()),
            Written::Lock(object, body) => {
                let object = self.real_value(object);
                let body = self.inner(body);
                StmtKind::Several(vec![self.expression_stmt(pos, object), body])
            }
            Written::Using(held, body) => self.using(pos, held, body),
            Written::Checked(on, block) => {
                let outer = (self.checked, self.unchecked);
                (self.checked, self.unchecked) = (*on, !*on);
                let made = self.block(block).kind;
                (self.checked, self.unchecked) = outer;
                made
            }
            Written::Yield(value) => self.yield_statement(pos, value.as_ref()),
            Written::Goto(name) => StmtKind::Goto(self.named_label(name)),
            Written::GotoCase(value) => self.goto_case(pos, value.as_ref()),
            Written::Label(name, inner) => {
                let label = self.named_label(name);
                let inner = self.statement(inner);
                StmtKind::Several(vec![Stmt { pos, kind: StmtKind::Label(label) }, inner])
            }
        }
    }

    fn thrown(&mut self, e: &ast::Expr, exception: Ty) -> Expr {
        let item = self.item(e);
        if let Item::Value(value) = &item
            && !self.converts(&item, exception)
            && value.ty != Ty::DYNAMIC
        {
            return self.error(e.pos, 155, "The type caught or thrown must be derived from System.Exception");
        }
        self.convert(item, exception, e.pos)
    }

    fn named_label(&mut self, name: &ast::Name) -> Label {
        if let Some(label) = self.labels.get(name) {
            return *label;
        }
        let label = self.label();
        self.labels.insert(name.clone(), label);
        label
    }

    /// A statement with a scope of its own.
    pub(super) fn inner(&mut self, stmt: &ast::Stmt) -> Stmt {
        let (inner, locals) = self.in_scope(|b| b.statement(stmt));
        if locals.is_empty() {
            return inner;
        }
        Stmt { pos: stmt.pos, kind: StmtKind::Block(locals, vec![inner]) }
    }

    pub(super) fn loop_body(&mut self, body: &ast::Stmt) -> (Stmt, Label, Label) {
        let (brk, cont) = (self.label(), self.label());
        let depth = self.functions.len() as u32;
        self.jumps.push(Jump { brk: Some(brk), cont: Some(cont), depth });
        let body = self.inner(body);
        self.jumps.pop();
        (body, brk, cont)
    }

    fn jump(&mut self, pos: Pos, is_break: bool) -> StmtKind {
        let depth = self.functions.len() as u32;
        let found = self
            .jumps
            .iter()
            .rev()
            .filter(|j| j.depth == depth)
            .find_map(|j| if is_break { j.brk } else { j.cont });
        match found {
            Some(label) => StmtKind::Goto(label),
            None => {
                self.fault(pos, 139, "No enclosing loop out of which to break or continue");
                StmtKind::Several(Vec::new())
            }
        }
    }

    fn local_variables(&mut self, ty: &ast::TypeRef, variables: &[Variable], constant: bool) -> StmtKind {
        let mut made = Vec::new();
        let written = if matches!(ty.kind, TypeRefKind::Var) { None } else { Some(self.resolve(ty)) };
        if written == Some(Ty::VOID) {
            self.fault(ty.pos, 1547, "Keyword 'void' cannot be used in this context");
        }
        if written.is_none() && variables.len() > 1 {
            let message = "Implicitly-typed variables cannot have multiple declarators";
            self.fault(ty.pos, 819, message);
        }
        for variable in variables {
            let pos = variable.pos;
            if constant {
                self.local_constant(written.unwrap_or(Ty::ERROR), variable);
                continue;
            }
            let value = match (&variable.value, written) {
                (None, None) => Some(self.error(pos, 818, "Implicitly-typed variables must be initialized")),
                (None, Some(_)) => None,
                (Some(e), Some(ty)) => Some(self.initial(e, ty)),
                (Some(e), None) => Some(self.inferred(e)),
            };
            let ty = written.unwrap_or_else(|| value.as_ref().map_or(Ty::ERROR, |v| v.ty));
            let local = self.declare(pos, &variable.name, ty, Passing::Value);
            let place = self.local(local, pos);
            match value {
                Some(value) => {
                    let set = make(ty, pos, Kind::Assign(Box::new(place), Box::new(value)));
                    made.push(self.expression_stmt(pos, set));
                }
                None => {
                    // A variable of a loop's body begins anew each time round; nothing reads it before it is set.
                    let set = make(
                        ty,
                        pos,
                        Kind::Assign(Box::new(place), Box::new(make(ty, pos, Kind::Default(ty)))),
                    );
                    let mut stmt = self.expression_stmt(pos, set);
                    stmt.pos = 0;
                    made.push(stmt);
                }
            }
        }
        StmtKind::Several(made)
    }

    /// The first value of a variable or field with a type.
    pub(super) fn initial(&mut self, e: &ast::Expr, ty: Ty) -> Expr {
        if let Some(wrong) = self.value_from_reference(e) {
            return wrong;
        }
        if let ExprKind::ArrayInit(values) = &e.kind {
            return self.array_of(e.pos, ty, values, &[]);
        }
        let item = self.item(e);
        self.convert(item, ty, e.pos)
    }

    fn inferred(&mut self, e: &ast::Expr) -> Expr {
        if let Some(wrong) = self.value_from_reference(e) {
            return wrong;
        }
        if matches!(e.kind, ExprKind::ArrayInit(_)) {
            return self.error(
                e.pos,
                820,
                "Cannot initialize an implicitly-typed variable with an array initializer",
            );
        }
        let item = self.item(e);
        let what = match &item {
            Item::Lambda(..) => Some("lambda expression"),
            Item::Methods(_) => Some("method group"),
            Item::Value(v) if v.ty == Ty::NULL => Some("<null>"),
            Item::Value(v) if v.ty == Ty::VOID => Some("void"),
            _ => None,
        };
        if let Some(what) = what {
            return self.error(e.pos, 815, format!("Cannot assign {what} to an implicitly-typed variable"));
        }
        self.as_value(item, e.pos)
    }

    fn local_constant(&mut self, ty: Ty, variable: &Variable) {
        let Some(e) = &variable.value else {
            self.fault(variable.pos, 145, "A const field requires a value to be provided");
            return;
        };
        let value = self.initial(e, ty);
        if value.ty != Ty::ERROR && !matches!(value.kind, Kind::Const(_)) {
            self.fault(
                e.pos,
                133,
                format!("The expression being assigned to '{}' must be constant", variable.name),
            );
        }
        self.enter(&variable.name, Entry::Constant(value));
    }

    fn return_statement(&mut self, pos: Pos, value: Option<&ast::Expr>) -> StmtKind {
        if self.functions.last().is_some_and(|f| f.yields.is_some()) {
            self.fault(pos, 1622, "Cannot return a value from an iterator. Use the yield return statement to return a value, or yield break to end the iteration.");
            return StmtKind::Return(None);
        }
        let returns = self.functions.last().map(|f| f.returns.clone());
        match (returns, value) {
            (Some(Returns::Infer(..)), value) => {
                let found = value.map(|e| {
                    let item = self.item(e);
                    match item {
                        Item::Tuple(..) => Item::Value(self.as_value(item, e.pos)),
                        item => item,
                    }
                });
                if let Some(Returns::Infer(types, untyped)) =
                    self.functions.last_mut().map(|f| &mut f.returns)
                {
                    match found {
                        Some(Item::Value(v)) if v.ty != Ty::NULL => types.push(v.ty),
                        Some(_) => *untyped = true,
                        None => {}
                    }
                }
                StmtKind::Return(None)
            }
            (Some(Returns::Type(ty)), None) => {
                if ty != Ty::VOID && ty != Ty::ERROR {
                    let shown = self.show(ty);
                    self.fault(pos, 126, format!("An object of a type convertible to '{shown}' is required"));
                }
                StmtKind::Return(None)
            }
            (Some(Returns::Type(ty)), Some(e)) => {
                if ty == Ty::VOID {
                    let _ = self.value(e);
                    self.fault(pos, 127, "Since this function returns void, a return keyword must not be followed by an object expression");
                    return StmtKind::Return(None);
                }
                if let Some(kind) = self.returned_reference(pos, e, ty) {
                    return kind;
                }
                StmtKind::Return(Some(self.initial(e, ty)))
            }
            (None, _) => StmtKind::Return(None),
        }
    }

    fn yield_statement(&mut self, pos: Pos, value: Option<&ast::Expr>) -> StmtKind {
        let Some(ty) = self.functions.last().and_then(|f| f.yields) else {
            self.fault(pos, 1624, "The body cannot be an iterator block because its return type is not an iterator interface type");
            return StmtKind::Several(Vec::new());
        };
        StmtKind::Yield(value.map(|e| {
            let item = self.item(e);
            self.convert(item, ty, e.pos)
        }))
    }

    fn try_statement(
        &mut self,
        body: &ast::Block,
        catches: &[ast::Catch],
        finally: Option<&ast::Block>,
    ) -> StmtKind {
        let body = self.block(body);
        let mut made = Vec::new();
        let mut seen: Vec<Ty> = Vec::new();
        for catch in catches {
            let ty = match &catch.ty {
                Some(ty) => self.resolve(ty),
                None => self.sema.known.exception,
            };
            if ty != Ty::ERROR && !self.sema.is_subtype(ty, self.sema.known.exception) {
                self.fault(catch.pos, 155, "The type caught or thrown must be derived from System.Exception");
            }
            if let Some(before) = seen.iter().copied().find(|s| self.sema.is_subtype(ty, *s)) {
                let shown = self.show(before);
                self.fault(catch.pos, 160, format!("A previous catch clause already catches all exceptions of this or of a super type ('{shown}')"));
            }
            if catch.filter.is_none() {
                seen.push(ty);
            }
            let ((local, filter, stmt), locals) = self.in_scope(|b| {
                let local = catch.name.as_ref().map(|name| b.declare(catch.pos, name, ty, Passing::Value));
                let filter = catch.filter.as_ref().map(|f| b.condition(f));
                let stmt = b.block(&catch.body);
                (local, filter, stmt)
            });
            let body = Stmt { pos: catch.pos, kind: StmtKind::Block(locals, vec![stmt]) };
            made.push(Catch { ty, local, filter, body });
        }
        let finally = finally.map(|f| Box::new(self.block(f)));
        StmtKind::Try(Box::new(body), made, finally)
    }

    pub(super) fn using(&mut self, pos: Pos, held: &ast::Stmt, body: &ast::Stmt) -> StmtKind {
        let (stmts, locals) = self.in_scope(|b| {
            let mut stmts = Vec::new();
            let mut resources = Vec::new();
            match &held.kind {
                Written::Local { variables, .. } => {
                    stmts.push(b.statement(held));
                    for variable in variables {
                        if let Some(Entry::Local(id)) = b.find(&variable.name) {
                            b.readonly_locals.push(id);
                            resources.push(id);
                        }
                    }
                }
                Written::Expr(e) => {
                    let value = b.real_value(e);
                    let local = b.new_local("", value.ty, Passing::Value);
                    let place = b.local(local, pos);
                    let ty = value.ty;
                    let set = make(ty, pos, Kind::Assign(Box::new(place), Box::new(value)));
                    stmts.push(b.expression_stmt(pos, set));
                    resources.push(local);
                }
                _ => {}
            }
            let mut inner = b.inner(body);
            for local in resources.into_iter().rev() {
                let resource = b.local(local, pos);
                let dispose = b.dispose(pos, resource);
                inner =
                    Stmt { pos, kind: StmtKind::Try(Box::new(inner), Vec::new(), Some(Box::new(dispose))) };
            }
            stmts.push(inner);
            stmts
        });
        StmtKind::Block(locals, stmts)
    }

    /// `if (x != null) x.Dispose();`
    pub(super) fn dispose(&mut self, pos: Pos, resource: Expr) -> Stmt {
        let disposable = self.sema.known.disposable;
        if resource.ty == Ty::ERROR {
            return Stmt { pos, kind: StmtKind::Several(Vec::new()) };
        }
        if resource.ty != Ty::DYNAMIC && self.sema.implicit(resource.ty, disposable).is_none() {
            let shown = self.show(resource.ty);
            self.fault(pos, 1674, format!("'{shown}': type used in a using statement must be implicitly convertible to 'System.IDisposable'"));
            return Stmt { pos, kind: StmtKind::Several(Vec::new()) };
        }
        let ty = resource.ty;
        let (number, held) = self.held(ty, pos);
        let part = ast::NamePart { pos, name: "Dispose".into(), args: Vec::new(), open: 0 };
        let held = self.retyped(held, disposable);
        let call = match self.member_of(pos, held, &part) {
            Item::Methods(group) => self.call_group(pos, *group, &[]),
            item => self.as_value(item, pos),
        };
        let whole = make(Ty::VOID, pos, Kind::Conditional(Box::new(resource), number, Box::new(call)));
        self.expression_stmt(pos, whole)
    }
}
