//! Text to nodes, whatever their types are.

use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

use crate::common::{Budget, Cost, Limits};
use crate::import::{Draft, Stop, fault};

/// A node: its type, and what its fields hold.
#[derive(Debug, Default)]
pub(super) struct Node {
    pub(super) kind: String,
    pub(super) span: Range<usize>,
    fields: HashMap<String, Value>,
    /// Nodes below it, on the longest way down.
    height: usize,
}

/// What a field holds.
#[derive(Debug)]
pub(super) enum Value {
    Numbers(Vec<f64>),
    Nodes(Vec<Rc<Node>>),
    /// TRUE, FALSE and texts.
    Word(String),
}

impl Node {
    /// Sets a field. It may be given twice in broken files: the last counts.
    fn set(&mut self, name: String, value: Value) {
        if let Value::Nodes(nodes) = &value {
            let below = nodes.iter().map(|node| node.height + 1);
            self.height = below.fold(self.height, usize::max);
        }
        self.fields.insert(name, value);
    }

    pub(super) fn numbers(&self, name: &str) -> &[f64] {
        match self.fields.get(name) {
            Some(Value::Numbers(numbers)) => numbers,
            _ => &[],
        }
    }

    pub(super) fn number(&self, name: &str, default: f64) -> f64 {
        self.numbers(name).first().copied().unwrap_or(default)
    }

    pub(super) fn three(&self, name: &str) -> Option<[f64; 3]> {
        self.numbers(name).get(..3)?.try_into().ok()
    }

    pub(super) fn nodes(&self, name: &str) -> &[Rc<Node>] {
        match self.fields.get(name) {
            Some(Value::Nodes(nodes)) => nodes,
            _ => &[],
        }
    }

    pub(super) fn node(&self, name: &str) -> Option<&Node> {
        self.nodes(name).first().map(Rc::as_ref)
    }

    /// A field that is TRUE or FALSE.
    pub(super) fn is(&self, name: &str, default: bool) -> bool {
        match self.fields.get(name) {
            Some(Value::Word(word)) => word == "TRUE",
            _ => default,
        }
    }
}

/// Reads all nodes of a file.
pub(super) fn parse<'b>(bytes: &'b [u8], draft: &mut Draft<'b>) -> Result<Vec<Rc<Node>>, Stop> {
    let mut parser = Parser { bytes, at: 0, names: HashMap::new(), budget: draft.budget };
    if bytes.starts_with(b"#VRML V1.0") {
        return Err(fault("VRML 1.0 is not read: export VRML97 (2.0)", Some(0..10)));
    }
    let mut nodes = Vec::new();
    while let Some((word, span)) = parser.peek() {
        match word {
            b"PROTO" | b"EXTERNPROTO" | b"ROUTE" => {
                draft.notices.note(&format!("{} ignored", String::from_utf8_lossy(word)), span);
                parser.skip_declaration(word);
            }
            _ => nodes.extend(parser.node(0)?),
        }
    }
    Ok(nodes)
}

struct Parser<'b> {
    bytes: &'b [u8],
    at: usize,
    names: HashMap<&'b [u8], Rc<Node>>,
    budget: &'b Budget<'b>,
}

impl<'b> Parser<'b> {
    /// The next token; commas are blanks, `#` starts a comment.
    fn peek(&mut self) -> Option<(&'b [u8], Range<usize>)> {
        loop {
            let rest = &self.bytes[self.at..];
            let blank = |b: &u8| b.is_ascii_whitespace() || *b == b',';
            self.at += rest.iter().position(|b| !blank(b)).unwrap_or(rest.len());
            match self.bytes.get(self.at)? {
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
                }
                _ => break,
            }
        }
        let rest = &self.bytes[self.at..];
        let length = match rest[0] {
            b'{' | b'}' | b'[' | b']' => 1,
            b'"' => text_length(rest),
            _ => {
                let ends = |b: &u8| {
                    b.is_ascii_whitespace() || matches!(b, b',' | b'{' | b'}' | b'[' | b']' | b'"' | b'#')
                };
                rest.iter().position(ends).unwrap_or(rest.len())
            }
        };
        Some((&rest[..length], self.at..self.at + length))
    }

    fn next(&mut self) -> Option<(&'b [u8], Range<usize>)> {
        let token = self.peek()?;
        self.at = token.1.end;
        Some(token)
    }

    fn expect(&mut self) -> Result<(&'b [u8], Range<usize>), Stop> {
        let end = self.bytes.len();
        self.next().ok_or_else(|| fault("the file ends within a node", Some(end..end)))
    }

    /// A node, or none for NULL and names that nothing has.
    fn node(&mut self, depth: usize) -> Result<Option<Rc<Node>>, Stop> {
        let (word, span) = self.expect()?;
        check_depth(depth, &span)?;
        match word {
            b"NULL" => Ok(None),
            b"USE" => {
                let (name, _) = self.expect()?;
                let node = self.names.get(name).cloned();
                // A chain of names would be as long as the file, and end in an overflow of the stack.
                check_depth(depth + node.as_ref().map_or(0, |node| node.height), &span)?;
                Ok(node)
            }
            b"DEF" => {
                let (name, _) = self.expect()?;
                let node = self.node(depth + 1)?;
                if let Some(node) = &node {
                    self.names.insert(name, Rc::clone(node));
                }
                Ok(node)
            }
            _ => self.body(word, span, depth).map(Some),
        }
    }

    fn body(&mut self, kind: &[u8], span: Range<usize>, depth: usize) -> Result<Rc<Node>, Stop> {
        let (open, place) = self.expect()?;
        if open != b"{" {
            let message = format!("found `{}`, expected `{{` after `{}`", shown(open), shown(kind));
            return Err(fault(message, Some(place)));
        }
        self.budget.spend(Cost::Node, 1)?;
        let mut node = Node { kind: String::from_utf8_lossy(kind).into_owned(), span, ..Node::default() };
        loop {
            let (name, place) = self.expect()?;
            match name {
                b"}" => return Ok(Rc::new(node)),
                b"{" | b"[" | b"]" => {
                    let message = format!("found `{}`, expected a field of `{}`", shown(name), node.kind);
                    return Err(fault(message, Some(place)));
                }
                b"ROUTE" => self.skip_declaration(name),
                _ => {
                    self.budget.spend(Cost::Word, 1)?;
                    let value = self.value(depth)?;
                    node.set(String::from_utf8_lossy(name).into_owned(), value);
                }
            }
        }
    }

    fn value(&mut self, depth: usize) -> Result<Value, Stop> {
        let (word, _) = self.peek().unwrap_or((b"", 0..0));
        match word.first() {
            Some(b'[') => self.list(depth),
            Some(b'0'..=b'9' | b'-' | b'+' | b'.') => {
                let mut numbers = Vec::new();
                while let Some(number) = self.number() {
                    self.budget.spend(Cost::Number, 1)?;
                    numbers.push(number);
                }
                if numbers.is_empty() {
                    // Something like `-` that is no number.
                    self.next();
                }
                Ok(Value::Numbers(numbers))
            }
            _ if matches!(word, b"TRUE" | b"FALSE") || word.starts_with(b"\"") => {
                self.next();
                Ok(Value::Word(shown(word)))
            }
            _ => Ok(Value::Nodes(self.node(depth + 1)?.into_iter().collect())),
        }
    }

    fn list(&mut self, depth: usize) -> Result<Value, Stop> {
        self.next();
        let (mut numbers, mut nodes) = (Vec::new(), Vec::new());
        loop {
            while let Some(number) = self.number() {
                self.budget.spend(Cost::Number, 1)?;
                numbers.push(number);
            }
            let Some((word, _)) = self.peek() else {
                let end = self.bytes.len();
                return Err(fault("the file ends within a list", Some(end..end)));
            };
            match word {
                b"]" => break,
                b"TRUE" | b"FALSE" => drop(self.next()),
                _ if word.starts_with(b"\"") => drop(self.next()),
                _ => nodes.extend(self.node(depth + 1)?),
            }
        }
        self.next();
        Ok(if nodes.is_empty() { Value::Numbers(numbers) } else { Value::Nodes(nodes) })
    }

    fn number(&mut self) -> Option<f64> {
        let (word, span) = self.peek()?;
        // Names such as `inf` and `nan` are numbers for Rust.
        if !matches!(word[0], b'0'..=b'9' | b'-' | b'+' | b'.') {
            return None;
        }
        let number: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
        self.at = span.end;
        Some(number)
    }

    /// Goes beyond a declaration: its blocks in brackets, or the four words of a route.
    fn skip_declaration(&mut self, word: &[u8]) {
        if word == b"ROUTE" {
            for _ in 0..3 + usize::from(self.peek().is_some_and(|(w, _)| w == b"ROUTE")) {
                self.next();
            }
            return;
        }
        let blocks = if word == b"PROTO" { 2 } else { 1 };
        let (mut open, mut closed) = (0_usize, 0);
        while let Some((token, _)) = self.next() {
            match token {
                b"[" | b"{" => open += 1,
                b"]" | b"}" => {
                    open = open.saturating_sub(1);
                    closed += usize::from(open == 0);
                }
                _ => {}
            }
            if open == 0 && closed >= blocks {
                return;
            }
        }
    }
}

fn check_depth(depth: usize, span: &Range<usize>) -> Result<(), Stop> {
    if depth > Limits::NESTING {
        return Err(fault(format!("nodes nest deeper than {}", Limits::NESTING), Some(span.clone())));
    }
    Ok(())
}

/// Length of a text in quotes; `\` keeps a quote from ending it.
fn text_length(bytes: &[u8]) -> usize {
    let mut i = 1;
    while i < bytes.len() {
        match bytes[i] {
            b'\\' => i += 2,
            b'"' => return i + 1,
            _ => i += 1,
        }
    }
    bytes.len()
}

fn shown(word: &[u8]) -> String {
    String::from_utf8_lossy(word).chars().take(60).collect()
}
