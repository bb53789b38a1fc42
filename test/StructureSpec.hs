-- | What the tree of modules promises: stages that only look back, and no test left out.
module StructureSpec
  ( spec,
  )
where

import Control.Monad (forM, forM_)
import Data.Char (isAlphaNum, isDigit)
import Data.List (elemIndex, inits, intercalate, isPrefixOf, isSuffixOf, sort, stripPrefix, tails)
import Data.Maybe (isNothing, listToMaybe, mapMaybe, maybeToList)
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (dropExtension, splitDirectories, (</>))
import Test.Hspec (Spec, it, shouldBe, shouldReturn, shouldSatisfy)
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "imports only from the same stage or an earlier one" $ do
    modules <- sources "src"
    length modules `shouldSatisfy` (> 40)
    offences <- concat <$> forM modules (\path -> backward path <$> importsOf path)
    offences `shouldBe` []
  it "puts every module into a stage" $ do
    modules <- sources "src"
    [m | path <- modules, let { m = moduleName "src" path }, isNothing (stageOf m)] `shouldBe` []
  it "tells of the stages everywhere in their order" $ do
    let stagesIn begins path = mapMaybe begins . lines <$> readFile path
        between before after text = stripPrefix before text >>= \rest -> listToMaybe [name | (name, end) <- zip (inits rest) (tails rest), after `isPrefixOf` end]
    forM_ ["README.md", "README.fr.md"] $ \path -> stagesIn (between "| [" "](src/Dioptre/") path `shouldReturn` stages
    stagesIn (between "-- [" "] ") "src/Dioptre.hs" `shouldReturn` stages
    stagesIn (between "- The folders of src/Dioptre are stages: " ". A module") "CONTRIBUTING.md" `shouldReturn` [intercalate ", " stages]
  it "runs every spec" $ do
    specs <- filter ("Spec" `isSuffixOf`) . map (moduleName "test") <$> sources "test"
    listed <- filter ("Spec" `isSuffixOf`) <$> importsOf "test/Main.hs"
    sort listed `shouldBe` sort specs
  it "imports JuicyPixels in one module only" $ do
    modules <- sources "src"
    users <- concat <$> forM modules (\path -> (\is -> [path | any ("Codec.Picture" `isPrefixOf`) is]) <$> importsOf path)
    users `shouldBe` ["src/Dioptre/Picture/Png.hs"]
  it "lets only the checker make a scene" $ do
    modules <- sources "src"
    users <- concat <$> forM modules (\path -> (\is -> [path | "Dioptre.Scene.Unchecked" `elem` is]) <$> importsOf path)
    users `shouldBe` ["src/Dioptre/Scene/Check.hs", "src/Dioptre/Scene.hs"]
  it "has no catch-all module" $ do
    modules <- sources "src"
    forM_ modules $ \path ->
      last (splitDirectories (dropExtension path)) `shouldSatisfy` (`notElem` ["Utils", "Util", "Types", "Common", "Misc", "Helpers"])
  -- Note [Literals] of "Dioptre.Math.Roots"
  it "has no number that GHC makes at run time" $ do
    literals "x > 1e-280 && 0x1p-400 < y || z == 1.5e100 || e128 -- 1e300" `shouldBe` [-280, -400, 100]
    folders <- mapM (sources . ("src/Dioptre" </>)) ["Math", "Geometry", "Optics", "Light", "Picture", "Render"]
    found <- forM (concat folders) $ \path -> (\text -> [(path, e) | e <- concatMap literals (lines text), abs e > 100]) <$> readFile path
    concat found `shouldBe` []

-- | The exponents of the numbers in a line of code.
literals :: String -> [Int]
literals line = concatMap exponentOf (numerals (code line))
  where
    code ('-' : '-' : _) = ""
    code (c : rest) = c : code rest
    code "" = ""
    -- Words that begin with a digit, each with the sign of its exponent.
    numerals text = case dropWhile (not . partOfWord) text of
      "" -> []
      found@(c : _) ->
        let (word, rest) = span partOfWord found
         in case rest of
              '-' : more | isDigit c, last word `elem` "ep" -> let (digits, further) = span isDigit more in (word ++ '-' : digits) : numerals further
              _ -> [word | isDigit c] ++ numerals rest
    partOfWord c = isAlphaNum c || c `elem` "._'"
    exponentOf word = case break (== (if "0x" `isPrefixOf` word then 'p' else 'e')) word of
      (_, _ : digits) -> maybeToList (readMaybe digits)
      _ -> []

-- | The stages, in the order in which a scene passes through them.
stages :: [String]
stages = ["Source", "Syntax", "Math", "Geometry", "Optics", "Light", "Scene", "Model", "Picture", "Render", "Explain", "Files", "Load", "View", "Conformance", "Command"]

-- | The number of a module's stage. The façade comes after all of them.
stageOf :: String -> Maybe Int
stageOf "Dioptre" = Just (length stages)
stageOf m = case stripPrefix "Dioptre." m of
  Just rest -> elemIndex (takeWhile (/= '.') rest) stages
  Nothing -> Nothing

backward :: FilePath -> [String] -> [(String, String)]
backward path imports = [(name, i) | i <- imports, Just theirs <- [stageOf i], Just ours <- [stageOf name], theirs > ours]
  where
    name = moduleName "src" path

moduleName :: FilePath -> FilePath -> String
moduleName root path = map dot (dropExtension (drop (length root + 1) path))
  where
    dot c = if c == '/' then '.' else c

importsOf :: FilePath -> IO [String]
importsOf path = mapMaybe imported . lines <$> readFile path
  where
    imported text = case filter (/= "qualified") (words text) of
      "import" : m : _ -> Just m
      _ -> Nothing

-- | Every Haskell file below a folder.
sources :: FilePath -> IO [FilePath]
sources folder = do
  entries <- sort <$> listDirectory folder
  concat
    <$> forM
      entries
      ( \entry -> do
          let path = folder </> entry
          isFolder <- doesDirectoryExist path
          if isFolder then sources path else pure [path | ".hs" `isSuffixOf` entry]
      )
